#pragma once
#include "phrame/algebra/rational_function.hpp"
#include "phrame/ph/curve/curve_jet.hpp"
#include "phrame/ph/curve/curve_point.hpp"

namespace phrame::inline v0 {

/// What is integrated along a curve, for any parameter: y dt does not depend on it. It is analytic
/// where the curve is and where what it divides by is not 0; σ = |r′|² is in it always.
struct CurveIntegrand {
  /// What it is; ρ = |r′ × r″|².
  enum class Kind {
    length,             ///< |r′| = √σ
    curvature,          ///< κ|r′| = √ρ/σ; ρ ≠ 0
    torsion,            ///< τ|r′| = det(r′, r″, r‴)·√σ/ρ; ρ ≠ 0
    bending,            ///< κ²|r′| = ρ/√σ⁵
    squared_torsion,    ///< τ²|r′| = det(r′, r″, r‴)²·√σ/ρ²; ρ ≠ 0
    up_frame,           ///< (v·r′)·det(v, r′, r″)/(√σ·|v × r′|²); v × r′ ≠ 0
    time_by_parameter,  ///< √σ/V(t)
    time_by_curvature,  ///< √σ/V(det(r′, r″, n)/(|n|√σ³)), in the plane with the normal n
  };
  Kind kind;                  ///< which one
  int sign = 1;               ///< −1 for −y
  Vector<Rational> vector{};  ///< v, n
  RationalFunction speed{};   ///< V

  /// y around a point of a curve.
  DiscProduct operator()(const CurveJet& jet) const;
  /// y at a point of it.
  RealBall operator()(const CurvePoint& point) const;

  /// The same kind with the same sign, vector and speed.
  friend bool operator==(const CurveIntegrand&, const CurveIntegrand&) = default;
};

/// @{ The integrands of these kinds.
CurveIntegrand length_rate();
CurveIntegrand curvature_rate();
CurveIntegrand torsion_rate();
CurveIntegrand bending_rate();
CurveIntegrand squared_torsion_rate();
/// @}
/// How fast the frame of v, e₂ = v × r′/|v × r′| and e₃ = e₁ × e₂, turns about e₁: e₂′·e₃.
CurveIntegrand up_frame_rate(const Vector<Rational>& v);
/// @{ |r′|/V, the time that a motion takes with a speed V that is a function of t + shift; and of
/// the signed curvature of a curve in the plane with this normal. Analytic where V has no zero and
/// no pole.
CurveIntegrand time_by_parameter(const RationalFunction& speed, const Rational& shift);
CurveIntegrand time_by_curvature(const RationalFunction& speed, const Vector<Rational>& normal);
/// @}
/// −y.
CurveIntegrand negative(CurveIntegrand y);

}  // namespace phrame
