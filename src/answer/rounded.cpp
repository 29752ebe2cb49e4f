#include "phrame/answer/rounded.hpp"

#include <algorithm>

#include "phrame/algebra/error.hpp"
#include "phrame/ph/curve/place.hpp"

namespace phrame::inline v0 {

Decimal rounded(const Real& x, const std::string& name, long digits) {
  try {
    return round_to_decimal(x, digits);
  } catch (const Undecided& error) {
    throw Undecided(name + ": " + error.what());
  }
}

Decimal rounded(const PathTotal& total, const std::string& name, long digits) {
  const bool is_closed_form =
      std::none_of(total.segments.begin(), total.segments.end(),
                   [](const auto& of) { return std::holds_alternative<Real>(of); });
  return is_closed_form || total.value.origin().is_irrational
             ? rounded(total.value, name, digits)
             : rounded_or_zero(total.value, name, digits);
}

Decimal rounded_or_zero(const Real& x, const std::string& name, long digits, long shown_digits) {
  const long most_bits = 14 * digits + 128;
  try {
    return round_to_decimal(x, shown_digits, {0, most_bits});
  } catch (const Undecided& undecided) {
    const RealBall ball = x.enclose(most_bits);
    if (!ball.is_finite() || !ball.contains_zero()) throw Undecided(name + ": " + undecided.what());
    return {"0", upper_bound_text(std::max(Rational(-ball.lower()), ball.upper()))};
  }
}

Decimal rounded_or_zero(const Real& x, const std::string& name, long digits) {
  return rounded_or_zero(x, name, digits, digits);
}

ErrorSize error_size(const Real& number, const std::string& name, long digits) {
  constexpr long few = 6;
  const Real x = cached(number);
  const Decimal value = rounded_or_zero(x, name, digits);
  if (value.value == "0" && value.radius != "0")
    return {{value.radius, value.radius}, "≤ " + value.radius, true};
  return {value, rounded_or_zero(x, name, std::max(digits, few), few).value};
}

Decimal rounded_as_known(const RealBall& x, long digits) {
  if (!x.is_finite()) throw Undecided("a number is not told within the digits of its parameter");
  const Rational lower = x.lower();
  const Rational upper = x.upper();
  const Rational most = std::max(abs(lower), abs(upper));
  if (sign(lower) * sign(upper) <= 0) return {"0", upper_bound_text(most)};
  const auto half_unit = [&](long known) -> Rational {
    return power_of_ten(decimal_exponent(most) + 1 - known) / 2;
  };
  for (long known = digits; known > 0; --known) {
    const std::string value = round_to_decimal(lower, known).value;
    if (value == round_to_decimal(upper, known).value)
      return {value, upper_bound_text(half_unit(known))};
  }
  return {round_to_decimal(x.midpoint(), 1).value, upper_bound_text(x.radius() + half_unit(1))};
}

Decimal rounded_as_known(const Real& x, const std::string& name, long digits) {
  if (x.exact()) return rounded_or_zero(x, name, digits);
  long bits = 128;
  RealBall near = x.enclose(bits);
  for (; !near.is_finite() && bits < 8192; bits *= 4) near = x.enclose(4 * bits);
  if (near.is_accurate(bits / 2)) return rounded_or_zero(x, name, digits);
  return rounded_as_known(near, digits);
}

BoundaryEnd boundary_end(const RationalCurve& curve, const Real& t, const Real& of_path,
                         long digits) {
  const auto at = [&](std::size_t k) {
    return rounded_as_known(value({curve.numerator()[k], curve.weight()}, Place(0, t)),
                            "a point of the boundary", digits);
  };
  return {of_path, t, rounded_as_known(of_path, "t of a cut", digits), {at(0), at(1)}};
}

}  // namespace phrame
