#pragma once
#include "phrame/io/read/curve_file.hpp"
#include "phrame/io/read/given_segment.hpp"
#include "phrame/io/read/json_node.hpp"
#include "phrame/ph/curve/bspline.hpp"

namespace phrame::inline v0 {

/// Points of the plane, for which z = 0, or of space: all of as many coordinates as the first.
std::vector<Vector<Rational>> read_points_of_any_dimension(const JsonNode& list);

/// That of a B-spline. Throws InputError for what is no whole number from 1 to the limit.
long read_degree(const JsonNode& node, const CurveLimits& limits);

/// What a B-spline is called in a format.
struct BSplineKeys {
  std::string degree = "degree";
  std::string knots = "knots";
};
/// The members `degree` and `knots` of an object, with the points and weights that are elsewhere;
/// "multiplicities" of the knots may be there, too. Throws InputError at what fault_of() finds.
std::vector<GivenSegment> bspline_segments(const JsonNode& node, const BSplineKeys& keys,
                                           const JsonNode& points,
                                           const std::optional<JsonNode>& weights,
                                           const CurveLimits& limits);

/// A bspline/1 or nurbs/1 object.
std::vector<GivenSegment> read_bspline(const JsonNode& node, const CurveLimits& limits);

}  // namespace phrame
