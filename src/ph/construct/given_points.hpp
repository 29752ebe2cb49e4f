#pragma once
#include <string>
#include <vector>

#include "phrame/ph/curve/rotation.hpp"

namespace phrame::inline v0 {

/// How a body lies at points, beside where it is.
struct GivenPoses {
  std::vector<Orientation> bodies;  ///< one for each point
  TangentAxis tangent = {};         ///< of the bodies
  /// So many revolutions about the tangent more than the fewest, to each point from the one before,
  /// at last, of a closed curve, to the first; empty for none.
  std::vector<long> turns = {};
  bool is_smooth = false;  ///< FrameThrough::is_smooth
  friend bool operator==(const GivenPoses&, const GivenPoses&) = default;
};

/// Points that a curve is to pass, with what else is known of it there. A list is empty or has as
/// many entries as there are points; parameters may have one more, of the end of a closed curve.
struct GivenPoints {
  std::string name;                           ///< may be empty
  std::vector<Vector<Rational>> points;       ///< two at least; of points of a plane, z = 0
  std::vector<Vector<Rational>> derivatives;  ///< with respect to the parameter
  std::vector<Vector<Rational>> tangents;     ///< not 0, of any length; only their directions count
  std::vector<Vector<Rational>> accelerations;  ///< second derivatives
  std::vector<Rational> parameters;             ///< increasing
  bool is_planar = false;                       ///< two coordinates were given
  std::optional<GivenPoses> poses = {};         ///< their tangents are those of the curve
  /// @{ Of a table: the column of the parameters, where it is not called t, and what was skipped.
  std::string parameter_column = {};
  std::vector<std::string> skipped_columns = {};
  std::vector<std::string> notes = {};  ///< what else was assumed, in sentences without a point
  /// @}
  friend bool operator==(const GivenPoints&, const GivenPoints&) = default;
};

}  // namespace phrame
