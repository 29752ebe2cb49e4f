#include "phrame/io/read/three_file.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "phrame/algebra/as_written.hpp"
#include "phrame/algebra/error.hpp"
#include "phrame/io/read/bspline_node.hpp"
#include "phrame/ph/curve/ellipse_arc.hpp"
#include "phrame/ph/curve/scale.hpp"
#include "phrame/ph/curve/vector.hpp"

// The curves are those of three.js's documentation and behaviour, r150 and later: what follows is
// written from the formulas of the curves.

namespace phrame::inline v0 {
namespace {

using ThreePoints = std::vector<Vector<Rational>>;
using Segments = std::vector<GivenSegment>;

Vector<Rational> read_three_point(const JsonNode& node) {
  node.require(JsonNode::Kind::array, "an array of 2 or 3 numbers");
  if (node.size() != 2 && node.size() != 3)
    node.fail(fmt::format("a point has 2 or 3 coordinates, not {}", node.size()));
  Vector<Rational> point;
  for (std::size_t c = 0; c < node.size(); ++c) point[c] = node.item(c).number();
  return point;
}

Segments read_three_bezier(const JsonNode& node, std::initializer_list<const char*> keys) {
  RationalBezier bezier;
  for (const char* key : keys) bezier.points.push_back(read_three_point(node.at(key)));
  return {bezier_segment(bezier, node.place())};
}

bool read_flag(const JsonNode& node, const std::string& key) {
  const auto flag = node.find(key);
  return flag && flag->boolean();
}

/// The cubic from b to c, where its derivatives on [0, 1] are these.
RationalBezier hermite_cubic(const Vector<Rational>& b, const Vector<Rational>& at_b,
                             const Vector<Rational>& c, const Vector<Rational>& at_c) {
  const Rational third(1, 3);
  return {{b, b + third * at_b, c - third * at_c, c}};
}

/// |c − b| or its square root, as a double; 0 for the same point.
Rational step_between(const Vector<Rational>& b, const Vector<Rational>& c, bool is_chordal) {
  const Vector<Rational> chord = c - b;
  if (chord == Vector<Rational>{}) return 0;
  return is_chordal ? rounded_length(chord, 50) : rounded_root_of_length(chord, 50);
}

/// The cubic between b and c of the non-uniform Catmull–Rom spline [Barry, Goldman 1988].
RationalBezier catmull_rom(const std::array<Vector<Rational>, 4>& p, bool is_chordal) {
  std::array<Rational, 3> step;
  for (std::size_t k = 0; k < 3; ++k) step[k] = step_between(p[k], p[k + 1], is_chordal);
  const Rational tiny(1, 10000);  // of points that are almost the same
  if (step[1] < tiny) step[1] = 1;
  if (step[0] < tiny) step[0] = step[1];
  if (step[2] < tiny) step[2] = step[1];
  const auto slope = [&](std::size_t k) {
    return Rational(1 / step[k]) * (p[k + 1] - p[k]) -
           Rational(1 / Rational(step[k] + step[k + 1])) * (p[k + 2] - p[k]) +
           Rational(1 / step[k + 1]) * (p[k + 2] - p[k + 1]);
  };
  return hermite_cubic(p[1], step[1] * slope(0), p[2], step[1] * slope(1));
}

Segments read_catmull_rom(const JsonNode& node) {
  const JsonNode list = node.at("points");
  const ThreePoints points = read_points_of_any_dimension(list);
  const std::size_t n = points.size();
  if (n < 2) list.fail(fmt::format("a curve has at least 2 points, not {}", n));
  const bool is_closed = read_flag(node, "closed");
  std::string type = "centripetal";
  if (const auto given = node.find("curveType")) {
    type = given->string();
    if (type != "centripetal" && type != "chordal" && type != "catmullrom")
      given->fail(fmt::format("the type is centripetal, chordal or catmullrom, not \"{}\"",
                              abbreviated(type)));
  }
  Rational tension(1, 2);
  if (const auto given = node.find("tension")) tension = given->number();
  const auto at = [&](std::size_t k, std::size_t back) {  // point k − back
    if (is_closed) return points[(k + n - back) % n];
    if (k < back) return Rational(2) * points[0] - points[1];
    if (k - back >= n) return Rational(2) * points[n - 1] - points[n - 2];
    return points[k - back];
  };
  Segments segments;
  for (std::size_t k = 0; k + (is_closed ? 0 : 1) < n; ++k) {
    const std::array p{at(k, 1), at(k, 0), at(k + 1, 0), at(k + 2, 0)};
    const RationalBezier cubic = type == "catmullrom" ? hermite_cubic(p[1], tension * (p[2] - p[0]),
                                                                      p[2], tension * (p[3] - p[1]))
                                                      : catmull_rom(p, type == "chordal");
    segments.push_back(bezier_segment(cubic, list.item(k).place(), "the curve from here on"));
  }
  return segments;
}

/// Uniform, with the ends doubled.
Segments read_spline_curve(const JsonNode& node) {
  const JsonNode list = node.at("points");
  const ThreePoints points = read_points_of_any_dimension(list);
  const std::size_t n = points.size();
  if (n < 2) list.fail(fmt::format("a curve has at least 2 points, not {}", n));
  Segments segments;
  const Rational half(1, 2);
  for (std::size_t k = 0; k + 1 < n; ++k) {
    const Vector<Rational>& before = points[k == 0 ? 0 : k - 1];
    const Vector<Rational>& after = points[std::min(k + 2, n - 1)];
    segments.push_back(bezier_segment(hermite_cubic(points[k], half * (points[k + 1] - before),
                                                    points[k + 1], half * (after - points[k])),
                                      list.item(k).place(), "the curve from here on"));
  }
  return segments;
}

Segments read_ellipse(const JsonNode& node) {
  const auto number = [&](const char* key) { return node.at(key).number(); };
  const Rational rx = number("xRadius");
  const Rational ry = number("yRadius");
  for (const char* key : {"xRadius", "yRadius"})
    if (node.at(key).number() == 0) node.at(key).fail("the radius is 0");
  const Rational start = number("aStartAngle");
  const Rational end = number("aEndAngle");
  const bool is_clockwise = read_flag(node, "aClockwise");
  if (start == end) node.fail("the arc is empty: it begins and ends with the same angle");
  const auto rotation = node.find("aRotation");
  const PlaneVector axis = rotation_by_radians(rotation ? rotation->number() : Rational(0));
  const Ellipse ellipse{
      {number("aX"), number("aY")}, {rx * axis[0], rx * axis[1]}, {-ry * axis[1], ry * axis[0]}};
  Segments segments;
  const PlaneVector from = rotation_by_radians(start);
  const bool is_whole = rotation_by_radians(end - start) == PlaneVector{1, 0};
  const PlaneVector to = is_whole ? from : rotation_by_radians(end);
  for (const RationalBezier& arc : ellipse_arc(ellipse, from, to, !is_clockwise))
    segments.push_back(bezier_segment(arc, node.place()));
  return segments;
}

Segments read_three_nurbs(const JsonNode& node, const CurveLimits& limits) {
  const JsonNode list = node.at("controlPoints");
  list.require(JsonNode::Kind::array, "an array of points");
  BSpline spline;
  spline.degree = read_degree(node.at("degree"), limits);
  const JsonNode knots = node.at("knots");
  knots.require(JsonNode::Kind::array, "an array of knots");
  spline.knots = knots.numbers();
  for (std::size_t k = 0; k < list.size(); ++k) {
    const auto point = list.item(k).numbers(4);
    spline.points.push_back({point[0], point[1], point[2]});
    spline.weights.push_back(point[3]);
  }
  if (const auto fault = fault_of(spline)) node.fail(fault->reason);
  return span_segments(spline, knots.place());
}

Segments read_three_curve(const JsonNode& node, const CurveLimits& limits);

Segments read_curve_path(const JsonNode& node, const CurveLimits& limits) {
  if (const auto holes = node.find("holes"); holes && holes->size() > 0)
    holes->fail("a shape with holes is more than one curve");
  const JsonNode curves = node.at("curves");
  curves.require(JsonNode::Kind::array, "an array of curves");
  if (curves.size() == 0) curves.fail("a path has at least one curve");
  Segments segments;
  for (std::size_t k = 0; k < curves.size(); ++k)
    for (GivenSegment& segment : read_three_curve(curves.item(k), limits))
      segments.push_back(std::move(segment));
  return segments;
}

Segments read_three_curve(const JsonNode& node, const CurveLimits& limits) {
  node.require(JsonNode::Kind::object, "a curve of three.js");
  const std::string type = node.at("type").string();
  if (type == "LineCurve" || type == "LineCurve3") return read_three_bezier(node, {"v1", "v2"});
  if (type == "QuadraticBezierCurve" || type == "QuadraticBezierCurve3")
    return read_three_bezier(node, {"v0", "v1", "v2"});
  if (type == "CubicBezierCurve" || type == "CubicBezierCurve3")
    return read_three_bezier(node, {"v0", "v1", "v2", "v3"});
  if (type == "CatmullRomCurve3") return read_catmull_rom(node);
  if (type == "SplineCurve") return read_spline_curve(node);
  if (type == "EllipseCurve" || type == "ArcCurve") return read_ellipse(node);
  if (type == "NURBSCurve") return read_three_nurbs(node, limits);
  if (type == "CurvePath" || type == "Path" || type == "Shape")
    return read_curve_path(node, limits);
  if (type == "TubeGeometry" || type == "TubeBufferGeometry")
    return read_three_curve(node.at("path"), limits);
  node.at("type").fail(
      fmt::format("\"{}\" is no curve of three.js that is known", abbreviated(type)));
}

}  // namespace

bool is_three_file(const JsonNode& node) {
  if (!node.is(JsonNode::Kind::object) || node.find("phrame")) return false;
  const auto type = node.find("type");
  if (!type || !type->is(JsonNode::Kind::string)) return false;
  const std::string& name = type->string();
  constexpr std::array<std::string_view, 4> endings{"Curve", "Curve3", "Path", "Shape"};
  return name == "TubeGeometry" || name == "TubeBufferGeometry" ||
         std::any_of(endings.begin(), endings.end(),
                     [&](std::string_view ending) { return name.ends_with(ending); });
}

std::vector<GivenSegment> read_three(const JsonNode& node, const CurveLimits& limits) {
  return read_three_curve(node, limits);
}

}  // namespace phrame
