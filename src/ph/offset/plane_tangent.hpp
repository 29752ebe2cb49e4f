#pragma once
#include "phrame/ph/curve/curve.hpp"
#include "phrame/ph/offset/plane_direction.hpp"

namespace phrame::inline v0 {

/// The tangent of a PH curve in a plane z = const, in lowest terms:
///   e₁ = (x, y)/σ,  x² + y² = σ²,  r′ = speed·e₁,  φ′ = turn/σ,
/// with σ > 0 and the angle φ of e₁, by which it turns left.
struct PlaneTangent {
  Polynomial x;      ///< of σ·e₁
  Polynomial y;      ///< of σ·e₁
  Polynomial sigma;  ///< σ, without a real root
  Polynomial speed;  ///< f·|A|² = W²·(±|r′|), negative where e₁ is −r′/|r′|
  Polynomial turn;   ///< σφ′
};

/// Is z the same all along the curve?
bool is_level(const Curve& curve);
/// Throws DomainError where the curve is in no plane z = const.
PlaneTangent plane_tangent(const Curve& curve);

/// e₁ there, exact.
PlaneDirection direction(const PlaneTangent& tangent, const Rational& t);

}  // namespace phrame
