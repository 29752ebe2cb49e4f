#pragma once
#include <memory>

#include "phrame/algebra/surd.hpp"
#include "phrame/export.hpp"
#include "phrame/ph/along/path_angle.hpp"
#include "phrame/ph/along/totals.hpp"
#include "phrame/ph/curve/path.hpp"

namespace phrame::inline v0 {

/// An integral along a path from its start to its end, the sum of those along its segments.
struct PathTotal {
  /// The number √radicand · of.
  struct Term {
    Rational radicand;  ///< > 0
    ExactValue of;      ///< what √radicand is multiplied by
    friend bool operator==(const Term&, const Term&) = default;
  };
  /// The integral along one segment: in closed form along a PH curve that has one; along others a
  /// sum of square roots where it is seen to be one, else a number that is certain to any number of
  /// digits.
  using OfSegment = std::variant<std::shared_ptr<const CurveTotal>, Surd, Real>;
  std::vector<OfSegment> segments;  ///< what each adds, without corners
  /// Exact where it is seen to be rational, also where what is irrational of different segments
  /// cancels.
  Real value;
  /// The value as a sum, where it is known in finite terms. No product of two radicands is a
  /// square, so that there is one term for most paths.
  std::optional<std::vector<Term>> exact;
};
/// The value as a number.
PHRAME_API Real value_of(const PathTotal::OfSegment& segment);
/// The closed form, null where there is none.
PHRAME_API const CurveTotal* closed_form(const PathTotal::OfSegment& segment);

/// ∫ ds = ∫ |r′| dt.
PHRAME_API PathTotal total_length(const Path& path);
/// ∫ κ ds: how far the tangent turns, in radians, at corners, too, but without the half turns at
/// cusps.
PHRAME_API PathTotal total_curvature(const Path& path);
/// ∫ τ ds, in radians; the half turns of n and b at inflections and their jumps at joints are not
/// in it. Throws DomainError where a segment is a straight line, DomainError or Undecided where a
/// curve by formulas has an inflection and is in no plane.
PHRAME_API PathTotal total_torsion(const Path& path);
/// @{ ∫ κ² ds and ∫ (κ² + τ²) ds over the segments, infinite at most cusps, and not counted at
/// corners, where they are infinite, too; at inflections τ is finite. The pole is
/// that of the first segment that has one, a parameter of the path. That with τ throws as
/// total_torsion().
PHRAME_API std::variant<PathTotal, Infinite> bending_energy(const Path& path);
PHRAME_API std::variant<PathTotal, Infinite> frenet_energy(const Path& path);
/// @}

/// ∫ 2h/σ dt: how far the Euler–Rodrigues frame turns about e₁, through the joints, in radians.
PHRAME_API PathTotal erf_twist(const PhPath& path);
/// ∫ e₂′·e₃ dt of the frame that the angle is to: how far it turns about e₁, in radians, −θ at the
/// end.
PHRAME_API Real reference_twist(const PathAngle& angle);

/// @{ ∫ κ ds/2π of a path in one plane, its absolute rotation index: by how many turns its tangent
/// turns, left and right alike. Where it does not turn back, or the total curvature is known in
/// finite terms, the index is exact if it is rational; curves by formulas are not asked for that.
/// No value for a path that is not plane. The total curvature may be known already.
PHRAME_API std::optional<Real> absolute_rotation_index(const Path& path);
PHRAME_API std::optional<Real> absolute_rotation_index(const Path& path,
                                                       const PathTotal& curvature);
/// @}

}  // namespace phrame
