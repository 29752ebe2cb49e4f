#include "phrame/ph/frame/erf_turning.hpp"

#include "phrame/ph/along/rmf_angle.hpp"
#include "phrame/ph/curve/invariants.hpp"
#include "phrame/ph/curve/special_points.hpp"

namespace phrame::inline v0 {

ErfTurning erf_turning(const Curve& curve) {
  const QuaternionPolynomial& a = curve.preimage();
  ErfTurning turning{{}, {}, true};
  const Polynomial h = twist_numerator(a);
  if (h.is_zero()) return turning;
  turning.zeros = real_roots(rate_to_erf(a).numerator(), closed_interval(0, 1));
  turning.is_monotone = odd_inside(turning.zeros).empty();
  const RationalFunction slope = differentiate(
      RationalFunction(h * pow(curve.weight(), 2), curve.multiplier() * pow(sigma(a), 2)));
  if (slope.is_zero()) return turning;
  turning.extrema = odd(real_roots(slope.numerator(), closed_interval(0, 1)));
  return turning;
}

}  // namespace phrame
