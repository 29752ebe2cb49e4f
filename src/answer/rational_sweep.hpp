#pragma once
#include <optional>
#include <string>

#include "phrame/ph/curve/path.hpp"
#include "phrame/ph/sweep/rational_sweep.hpp"

namespace phrame::inline v0 {

/// Asks for an exact body: a profile swept along a path in a rational frame.
struct RationalSweepQuery {
  ProfileCurve profile;                   ///< x along f₂, y along f₃
  FrameStart start = {};                  ///< where the frame starts
  RationalFunction scale{Polynomial{1}};  ///< λ(t) > 0, by which the profile is scaled
  /// The degree of w, 1 to 8, of a rational frame of minimal twist that is taken instead of the
  /// rotation-minimizing frame.
  std::optional<long> twist_degree = {};
  /// f₂ at the end of that frame, before it is projected to the normal plane. A closed path has
  /// none: its frame ends as it starts.
  std::optional<Vector<Rational>> end_normal = {};
};

/// The surface of the body, without its caps.
struct RationalSweepAnswer {
  std::string name;                  ///< of the curve
  RationalSurface surface;           ///< exact
  std::optional<long> twist_degree;  ///< as asked
  std::optional<Nearness> near;      ///< of the curve, where it stands for another
};

/// Throws as path_with_tangents() of a path that is not PH, rational_rmf(), rational_mtf(),
/// best_twist() and rational_sweep(); DomainError for an end normal of a closed path, for none of
/// another one with a twist_degree, for that of a path that is not PH, for a start at an angle to
/// the frame of such a one, for corners, and for a closed path whose frame or scale is not the same
/// at both ends.
RationalSweepAnswer answer(const NamedPath& named, const RationalSweepQuery& query);

}  // namespace phrame
