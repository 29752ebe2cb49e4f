// With A i A* = (X, Y, 0) and |A|² = σ₀ it is X² + Y² = σ₀², so that the square of g = gcd(X, Y)
// divides that of σ₀, and g divides σ₀. In lowest terms x² + y² = σ² has no real root, as it would
// be a common one of x and y. Over ℚ(i) the coprime factors of σ² are x + iy and its conjugate:
// x + iy = c·w² and σ = |c||w|², so that σφ′ = 2|c| Im(w′w̄) is a polynomial.
#include "phrame/ph/offset/plane_tangent.hpp"

#include "phrame/algebra/error.hpp"
#include "phrame/ph/curve/invariants.hpp"

namespace phrame::inline v0 {

bool is_level(const Curve& curve) { return rotated_i(curve.preimage())[2].is_zero(); }

PlaneTangent plane_tangent(const Curve& curve) {
  const auto [x, y, z] = rotated_i(curve.preimage());
  if (!z.is_zero()) throw DomainError("plane_tangent: z changes along the curve");
  const Polynomial whole = sigma(curve.preimage());
  const Polynomial common = gcd(x, y);
  PlaneTangent tangent{exact_quotient(x, common),
                       exact_quotient(y, common),
                       exact_quotient(whole, common),
                       curve.multiplier() * whole,
                       {}};
  Rational unit = common_content({tangent.x, tangent.y, tangent.sigma});
  if (sign_after_zero(tangent.sigma) < 0) unit = -unit;
  for (Polynomial* p : {&tangent.x, &tangent.y, &tangent.sigma}) *p *= 1 / unit;
  tangent.turn = exact_quotient(
      tangent.x * differentiate(tangent.y) - differentiate(tangent.x) * tangent.y, tangent.sigma);
  return tangent;
}

PlaneDirection direction(const PlaneTangent& tangent, const Rational& t) {
  const Rational sigma = tangent.sigma(t);
  return {tangent.x(t) / sigma, tangent.y(t) / sigma};
}

}  // namespace phrame
