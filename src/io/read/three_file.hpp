#pragma once
#include "phrame/io/read/curve_file.hpp"
#include "phrame/io/read/given_segment.hpp"
#include "phrame/io/read/json_node.hpp"

namespace phrame::inline v0 {

/// Is it what the curves of three.js write by toJSON(): an object whose "type" ends with Curve,
/// Curve3, PhPath or Shape, or a TubeGeometry, until r144 a TubeBufferGeometry,
/// which has a curve?
bool is_three_file(const JsonNode& node);
/// The curve of such an object: lines, Bézier curves of degree 2 and 3, CatmullRomCurve3,
/// SplineCurve, EllipseCurve and ArcCurve, NURBSCurve, and CurvePath, PhPath and Shape of these.
/// The numbers are the doubles that the file has. Steps of the parameter that three.js computes,
/// those of centripetal and chordal Catmull–Rom curves, are rounded to doubles, as there; ellipses
/// that are not made of quarters as ellipse_arc() says. Segment k is the k-th curve between two
/// points.
std::vector<GivenSegment> read_three(const JsonNode& node, const CurveLimits& limits);

}  // namespace phrame
