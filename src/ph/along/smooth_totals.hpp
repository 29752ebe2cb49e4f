#pragma once
#include <variant>

#include "phrame/ph/along/path_angle.hpp"
#include "phrame/ph/along/totals.hpp"

namespace phrame {

// What a path of any kind gathers from its start to its end; they are certain to any number of
// digits, and exact where they are seen to be rational. Its length is that of PathLength.

/// ∫ κ ds: how far the tangent turns, in radians, without the half turns at cusps.
Real total_curvature(const Path& path);
/// ∫ τ ds, in radians; the half turns of n and b at inflections and their jumps at joints are not
/// in it. Throws DomainError where a segment is a straight line, DomainError or Undecided where a
/// curve by formulas has an inflection and is in no plane.
Real total_torsion(const Path& path);
/// ∫ κ² ds, infinite at most cusps.
std::variant<Real, Infinite> bending_energy(const Path& path);
/// ∫ (κ² + τ²) ds, infinite at most cusps; at inflections τ is finite. Throws DomainError where a
/// segment is a straight line, and as total_torsion().
std::variant<Real, Infinite> frenet_energy(const Path& path);
/// ∫ e₂′·e₃ dt of the frame of v that the angle is to: how far it turns about e₁, in radians, −θ at
/// the end.
Real up_frame_twist(const PathAngle& angle);

}  // namespace phrame
