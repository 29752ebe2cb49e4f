#include "phrame/answer/boundary_end.hpp"

#include "phrame/answer/rounded.hpp"
#include "phrame/ph/curve/place.hpp"

namespace phrame::inline v0 {

Decimal decimal_of(const RealBall& x) {
  constexpr long digits = 12;
  const Rational middle = x.midpoint();
  Decimal decimal = round_to_decimal(Real(middle), digits);
  decimal.radius = upper_bound_text(x.radius() + abs(middle) * power_of_ten(1 - digits));
  return decimal;
}

Decimal rounded_as_known(const Real& x, const std::string& name, long digits) {
  constexpr long bits = 128;
  const RealBall near = x.exact() ? RealBall() : x.enclose(bits);
  if (x.exact() || near.is_accurate(bits / 2)) return rounded_or_zero(x, name, digits);
  return decimal_of(near);
}

BoundaryEnd boundary_end(const RationalCurve& curve, const Real& t, const Real& of_path,
                         long digits) {
  const auto at = [&](std::size_t k) {
    return rounded_as_known(value({curve.numerator()[k], curve.weight()}, Place(0, t)),
                            "a point of the boundary", digits);
  };
  return {of_path, rounded_as_known(of_path, "t of a cut", digits), {at(0), at(1)}};
}

}  // namespace phrame
