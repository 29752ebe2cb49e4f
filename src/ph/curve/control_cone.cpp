#include "phrame/ph/curve/control_cone.hpp"

#include "phrame/ph/curve/invariants.hpp"
#include "phrame/ph/curve/shape.hpp"
#include "phrame/ph/curve/vector.hpp"

namespace phrame::inline v0 {

std::optional<ControlCone> control_cone(const Curve& curve) {
  if (!curve.is_polynomial() || degree(curve) != 3 || line_direction(curve.preimage())) return {};
  const std::vector<Vector<Rational>> points = control_points(curve);
  const auto leg = [&](std::size_t k) { return points[k + 1] - points[k]; };
  const Vector<Rational> L0 = leg(0), L1 = leg(1), L2 = leg(2);
  const Rational square = dot(L1, L1);
  // r′ is 3L₀ at t = 0 and 3L₂ at t = 1, and has the length |f|σ.
  const Polynomial speed = curve.multiplier() * sigma(curve.preimage());
  const Rational l0 = abs(speed(Rational(0))) / 3, l2 = abs(speed(Rational(1))) / 3;
  if (square == 0 || l0 == 0 || l2 == 0) return {};
  const Rational along = dot(L0, L1) / l0;  // cos ϑ·|L₁|
  return ControlCone{along * along / square, along < 0, 1 - 2 * square / (l0 * l2)};
}

}  // namespace phrame
