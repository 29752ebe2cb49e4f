#pragma once
#include "phrame/algebra/rational_function.hpp"
#include "phrame/export.hpp"
#include "phrame/ph/curve/place.hpp"

namespace phrame::inline v0 {

// Of a curve with r′ = p·H/W², σ = |H|², ρ = |H × H′|²; at a joint of a path, those of the segment
// named.

/// κ = √ρ·W²/(|p|·σ^{3/2}) ≥ 0 there. Throws DomainError where it is infinite, as at most cusps.
PHRAME_API Real curvature(const Path& path, const Place& at);
/// de₁/ds = κn there, rational where t and the curve are. Throws DomainError at a cusp.
PHRAME_API Vector<Real> curvature_vector(const Path& path, const Place& at);
/// dβ/ds there, where β = e₁ × de₁/ds is the angular velocity of a rotation-minimizing frame by the
/// length; likewise.
PHRAME_API Vector<Real> turning_slope(const Path& path, const Place& at);
/// τ = W²·det(H, H′, H″)/(p·ρ) there, rational where t and the curve are. Throws DomainError where
/// it is infinite and on a straight line, where it is undefined.
PHRAME_API Real torsion(const Path& path, const Place& at);

/// @{ κ² and τ of a rational curve in lowest terms. Throws DomainError for the torsion of a
/// straight line.
PHRAME_API RationalFunction squared_curvature(const RationalCurve& curve);
PHRAME_API RationalFunction torsion(const RationalCurve& curve);
/// @}

/// Is the Frenet frame defined all along, κ ≠ 0, and continuous through the joints, from the end of
/// a closed path to its start, too? Decided exactly; throws Undecided where formulas do not tell.
PHRAME_API bool has_continuous_frenet_frame(const Path& path);
/// Does the Frenet frame, continued through inflections, go on through the joints? Throws
/// DomainError where it jumps there, with the joint and the angle, and for a straight segment;
/// Undecided where formulas do not tell.
PHRAME_API void require_frenet_joints(const Path& path);

}  // namespace phrame
