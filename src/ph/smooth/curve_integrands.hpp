#pragma once
#include "phrame/algebra/rational_function.hpp"
#include "phrame/ph/smooth/expression_integral.hpp"

namespace phrame {

// What is integrated along a curve, analytic where the curve is and where what it divides by is
// not 0. ρ = |r′ × r″|².

CurveIntegrand length_rate();     ///< |r′|
CurveIntegrand curvature_rate();  ///< κ|r′| = √ρ/|r′|²; ρ ≠ 0
CurveIntegrand torsion_rate();    ///< τ|r′| = det(r′, r″, r‴)·|r′|/ρ; ρ ≠ 0
CurveIntegrand bending_rate();    ///< κ²|r′| = ρ/|r′|⁵
/// (κ² + τ²)|r′| = (ρ³ + |r′|⁶ det(r′, r″, r‴)²)/(|r′|⁵ρ²); ρ ≠ 0
CurveIntegrand frenet_energy_rate();
/// How fast the frame of v, e₂ = v × r′/|v × r′| and e₃ = e₁ × e₂, turns about e₁: e₂′·e₃ =
///   (v·r′)·det(v, r′, r″)/(|r′|·|v × r′|²),  v × r′ ≠ 0.
CurveIntegrand up_frame_rate(const Vector<Rational>& v);
/// @{ |r′|/V, the time that a motion takes with a speed V that is a function of t + shift; and of
/// the signed curvature of a curve in the plane with this normal, det(r′, r″, n)/(|n||r′|³).
/// Analytic where V has no zero and no pole.
CurveIntegrand time_by_parameter(const RationalFunction& speed, const Rational& shift);
CurveIntegrand time_by_curvature(const RationalFunction& speed, const Vector<Rational>& normal);
/// @}
/// −y.
CurveIntegrand negative(const CurveIntegrand& y);

}  // namespace phrame
