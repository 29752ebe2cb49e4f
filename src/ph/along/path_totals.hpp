#pragma once
#include "phrame/ph/along/totals.hpp"
#include "phrame/ph/curve/ph_path.hpp"

namespace phrame {

/// What a path gathers from its start to its end: the sum of what its segments do.
struct PathTotal {
  /// √radicand · of
  struct Term {
    Rational radicand;  ///< > 0
    ExactValue of;      ///< what √radicand is multiplied by
    friend bool operator==(const Term&, const Term&) = default;
  };
  std::vector<Total> segments;  ///< in closed form
  /// Exact where it is seen to be rational, also where what is irrational of different segments
  /// cancels.
  Real value;
  /// The sum that value is, where it is known in finite terms. No product of two radicands is a
  /// square, so that there is one term for most paths.
  std::optional<std::vector<Term>> exact;
};

/// @{ As the totals of a curve, which a path of one segment is. Where one segment has none, the
/// path has none.
PathTotal total_length(const PhPath& path);
PathTotal erf_twist(const PhPath& path);  ///< of the Euler–Rodrigues frame through the joints
/// @}
/// @{ As those of a curve. The pole is that of the first segment that has one, a parameter of the
/// path.
std::variant<PathTotal, Infinite> bending_energy(const PhPath& path);
std::variant<PathTotal, Infinite> frenet_energy(const PhPath& path);
/// @}
/// The Frenet frame may jump at a joint; this is no part of it.
PathTotal total_torsion(const PhPath& path);
/// No value where one segment has none.
std::optional<PathTotal> total_curvature(const PhPath& path);

/// ∫ κ ds/2π of a path in one plane, its absolute rotation index: by how many turns its tangent
/// turns, left and right alike. Where it does not turn back, or the total curvature is known in
/// finite terms, the index is exact if it is rational. No value for a path that is not plane.
std::optional<Real> absolute_rotation_index(const PhPath& path);

}  // namespace phrame
