#pragma once
#include "phrame/integrate/taylor_integral.hpp"
#include "phrame/ph/curve/rational_curve.hpp"

namespace phrame::inline v0 {

// What is integrated along a rational curve with r′ = p·H/W², σ = |H|², ρ = |H × H′|². Cusps, where
// p = 0, and inflections are no singularities of these but of the bending energy.

/// What the curvature and the torsion depend on besides p and W.
struct Turning {
  Polynomial sigma;   ///< σ
  Polynomial rho;     ///< ρ, 0 for a straight line
  Polynomial volume;  ///< det(H, H′, H″)
};
Turning turning_of(const RationalCurve& curve);  ///< these of the curve

Vector<Polynomial> across(const Vector<Rational>& v, const RationalCurve& curve);  ///< v × H

/// θ′ of the rotation-minimizing frame to the frame of v, −e₂′·e₃ =
///   −(v·H)·det(v, H, H′)/(√σ·|v × H|²).
RootQuotient up_frame_turning(const RationalCurve& curve, const Vector<Rational>& v);
/// The same to the Frenet frame, −n′·b = −√σ·det(H, H′, H″)/ρ. Throws DomainError for a straight
/// line.
RootQuotient frenet_turning(const RationalCurve& curve);

/// ds/dt with the sign of p, p√σ/W².
RootQuotient length_rate(const RationalCurve& curve);
/// @{ κ·|ds/dt| = √ρ/σ up to a sign that changes where ρ has a zero; 0 for a straight line. Of a PH
/// curve that is so with the σ and ρ of its preimage, too, which have lower degrees.
RootQuotient curvature_rate(const RationalCurve& curve);
RootQuotient curvature_rate(const QuaternionPolynomial& preimage);
/// @}
/// κ²·ds/dt = ρ·W²/(p·σ²·√σ), with the sign of p.
RootQuotient bending_rate(const RationalCurve& curve);
/// (κ² + τ²)·ds/dt = W²·(ρ³ + σ³·det(H, H′, H″)²)/(p·σ²·ρ²·√σ), likewise. Throws DomainError for a
/// straight line.
RootQuotient frenet_energy_rate(const RationalCurve& curve);

}  // namespace phrame
