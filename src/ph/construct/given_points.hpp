#pragma once
#include <string>
#include <vector>

#include "phrame/ph/curve/rotation.hpp"

namespace phrame::inline v0 {

/// How a body is oriented at each of the points that it passes.
struct GivenPoses {
  std::vector<Orientation> bodies;  ///< one for each point
  TangentAxis tangent = {};         ///< the axis of the body that is the tangent of the curve
  /// For each step from one point to the next, and of a closed curve from the last to the first:
  /// how many revolutions about the tangent are made in addition to the least turn. Empty for none.
  std::vector<long> turns = {};
  bool is_smooth = false;  ///< as FrameThrough::is_smooth
  friend bool operator==(const GivenPoses&, const GivenPoses&) = default;
};

/// Points that a curve is to pass, with what else is given there. Each list is empty or has one
/// entry for each point; `parameters` may have one more, for the end of a closed curve.
struct GivenPoints {
  std::string name;                             ///< may be empty
  std::vector<Vector<Rational>> points;         ///< at least two; z = 0 for points of a plane
  std::vector<Vector<Rational>> derivatives;    ///< with respect to the parameter
  std::vector<Vector<Rational>> tangents;       ///< only their directions count; not 0
  std::vector<Vector<Rational>> accelerations;  ///< second derivatives
  std::vector<Rational> parameters;             ///< increasing
  bool is_planar = false;                       ///< two coordinates were given
  std::optional<GivenPoses> poses = {};         ///< the curve has their tangents
  std::string parameter_column = {};  ///< of a table: the column of the parameters, if it is not t
  std::vector<std::string> skipped_columns = {};  ///< of a table: the columns that were not used
  std::vector<std::string> notes =
      {};  ///< what else was assumed, one sentence each, without a stop
  friend bool operator==(const GivenPoints&, const GivenPoints&) = default;
};

}  // namespace phrame
