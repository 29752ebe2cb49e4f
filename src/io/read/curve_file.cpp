#include "phrame/io/read/curve_file.hpp"

#include <fmt/format.h>

#include "phrame/algebra/error.hpp"
#include "phrame/algebra/rounding.hpp"
#include "phrame/io/read/any_path.hpp"
#include "phrame/io/read/curve_node.hpp"
#include "phrame/io/read/frame_node.hpp"
#include "phrame/io/read/rational_node.hpp"
#include "phrame/io/write/json_text.hpp"
#include "phrame/ph/construct/bezier_points.hpp"
#include "phrame/ph/construct/near.hpp"
#include "phrame/ph/curve/end_point.hpp"
#include "phrame/ph/curve/identify.hpp"
#include "phrame/ph/curve/transform.hpp"
#include "phrame/ph/curve/vector.hpp"

namespace phrame::inline v0 {
namespace {

using Node = JsonNode;
using Kind = JsonValue::Kind;

/// What read_path_near() might do; empty where it would not help.
std::string suggestion_for(const NamedHodograph& bezier, const std::string& near_option) {
  if (near_option.empty()) return "";
  const auto near = near_suggestion(bezier.hodograph, bezier.start);
  if (!near) return "";
  return fmt::format("; {} {} takes the PH curve {} from it", near_option,
                     upper_bound_text(near->epsilon, 1), upper_bound_text(near->distance));
}

/// One that only read_any_path() knows.
bool is_format_of_any_curve(std::string_view format) {
  return format == "bspline/1" || format == "nurbs/1" || format == "points/1";
}

/// Is it given in a way that only curves of any kind are?
bool is_given_as_rational(const Node& node) {
  return node.find("weights") || node.find("position") || node.find("expressions");
}

NamedCurve read_any_curve(const Node& node, const CurveLimits& limits) {
  if (is_given_as_rational(node)) {
    auto result = identify_segment(read_curve_segment(node, limits));
    if (const auto* reason = std::get_if<std::string>(&result))
      node.fail("this is no PH curve: " + *reason);
    return {read_name(node), std::get<Curve>(std::move(result))};
  }
  const auto points = node.find("control_points");
  if (!points) return read_preimage_curve(node, limits);
  NamedHodograph bezier = read_bezier(node, *points, limits);
  auto result = identify(bezier.hodograph, bezier.start);
  if (const auto* reason = std::get_if<NotPythagorean>(&result))
    points->fail("this is no PH curve: " + to_string(*reason) +
                 suggestion_for(bezier, limits.near_option));
  return {std::move(bezier.name), std::get<Curve>(std::move(result))};
}

/// A segment says where it starts, or starts where the spline ends.
void append_segment(PhPath& path, const Node& node, const CurveLimits& limits) {
  const Curve read = read_any_curve(node, limits).curve;
  const bool says_start = node.find("start") || node.find("control_points") ||
                          node.find("position") || node.find("tangents");
  const Curve& last = path.segments().back();
  const Curve next = says_start ? read : translated(read, end_point(last) - read.start());
  try {
    path.append(next);
  } catch (const DomainError& error) {
    node.fail(error.what());
  }
}

std::vector<Node> read_segments(const Node& spline) {
  spline.require_known_keys(
      {"phrame", "name", "segments", "frame", "note", "family", "expected", "id", "notes"});
  const Node list = spline.at("segments");
  list.require(Kind::array, "an array of curves");
  if (list.size() == 0) list.fail("a spline has at least one segment");
  std::vector<Node> segments;
  for (std::size_t k = 0; k < list.size(); ++k) {
    const Node& item = segments.emplace_back(list.item(k));
    item.require(Kind::object, "an object");
    if (item.find("phrame")) require_format(item, "curve/1");
    require_curve_keys(item);
  }
  return segments;
}

NamedPhPath read_spline(const Node& node, const CurveLimits& limits) {
  const std::vector<Node> segments = read_segments(node);
  NamedPhPath result{read_name(node), PhPath(read_any_curve(segments[0], limits).curve)};
  for (std::size_t k = 1; k < segments.size(); ++k)
    append_segment(result.path, segments[k], limits);
  result.frame = read_frame_through(node, segments.size());
  return result;
}

using NearReading = std::variant<NamedPhPath, NotNear>;

/// What near_curve or near_path finds; what it cannot do is an error at this place.
template <class Find>
NearReading found_near(const Node& node, std::string name, Find find) {
  try {
    auto result = find();
    if (const auto* none = std::get_if<NotNear>(&result)) return *none;
    auto& [path, nearness] = std::get<0>(result);
    return NamedPhPath(std::move(name), std::move(path), std::move(nearness));
  } catch (const DomainError& error) {
    node.fail(error.what());
  }
}

/// No value where all its segments are PH as they are.
std::optional<NearReading> read_spline_near(const Node& node, const Rational& epsilon,
                                            const CurveLimits& limits) {
  std::vector<BezierPoints> curves;
  bool all_ph = true;
  for (const Node& segment : read_segments(node)) {
    if (is_given_as_rational(segment)) return std::nullopt;
    const auto list = segment.find("control_points");
    if (list) {
      const NamedHodograph bezier = read_bezier(segment, *list, limits);
      all_ph = all_ph && std::holds_alternative<Curve>(identify(bezier.hodograph));
      curves.push_back(bezier_points(bezier.hodograph, bezier.start));
    } else {
      const Curve curve = read_preimage_curve(segment, limits).curve;
      const bool says_start = segment.find("start") || curves.empty();
      curves.push_back(
          bezier_points(hodograph(curve), says_start ? curve.start() : curves.back().back()));
    }
  }
  if (all_ph) return std::nullopt;
  return found_near(node.at("segments"), read_name(node),
                    [&] { return near_path(curves, epsilon); });
}

/// No value where it is PH as it is.
std::optional<NearReading> read_curve_near(const Node& node, const Rational& epsilon,
                                           const CurveLimits& limits) {
  require_curve_keys(node);
  const auto list = node.find("control_points");
  if (!list || is_given_as_rational(node)) return std::nullopt;
  NamedHodograph bezier = read_bezier(node, *list, limits);
  if (std::holds_alternative<Curve>(identify(bezier.hodograph))) return std::nullopt;
  return found_near(*list, std::move(bezier.name),
                    [&] { return near_curve(bezier.hodograph, bezier.start, epsilon); });
}

[[noreturn]] void refuse_rational(const Node& node) {
  node.fail("the curve is rational, and here a polynomial one is wanted");
}

/// Of a curve whose weight function is constant.
NamedHodograph hodograph_of(const Node& node, const RationalCurve& curve) {
  Vector<Polynomial> hodograph = curve.direction();
  for (Polynomial& h : hodograph) h *= curve.multiplier();
  return {read_name(node), std::move(hodograph), point(curve, 0)};
}

/// By control points with weights, or a position.
RationalCurve given_positions(const Node& node, const CurveLimits& limits) {
  GivenSegment segment = read_curve_segment(node, limits);
  if (std::holds_alternative<ExpressionCurve>(segment.form))
    node.fail(
        "the curve is given by formulas; only polynomials and quotients of them are "
        "identified as PH curves");
  return std::get<RationalCurve>(std::move(segment.form));
}

}  // namespace

NamedCurve read_curve(std::string_view text, const CurveLimits& limits) {
  const JsonValue document = parse_json_file(text, "curve file");
  return read_curve(JsonNode(document), limits);
}

NamedCurve read_curve(const JsonNode& node, const CurveLimits& limits) {
  require_curve(node);
  refuse_long_numbers(node);
  return read_any_curve(node, limits);
}

NamedPhPath read_path(std::string_view text, const CurveLimits& limits) {
  const JsonValue document = parse_json_file(text, "curve file");
  format_of(Node(document));
  return read_path(Node(document), limits);
}

NamedPhPath read_path(const JsonNode& node, const CurveLimits& limits) {
  node.require(Kind::object, "an object");
  refuse_long_numbers(node);
  const auto format = node.find("phrame");
  if (format && format->string() == "spline/1") return read_spline(node, limits);
  if (format && is_format_of_any_curve(format->string())) {
    if (auto ph = with_preimages(read_any_path(node, limits))) return *std::move(ph);
    node.fail("this is no path of PH curves");
  }
  if (format && format->string() != "curve/1")
    format->fail(fmt::format("the format is \"curve/1\" or \"spline/1\", not \"{}\"",
                             abbreviated(format->string())));
  require_curve_keys(node);
  return read_any_curve(node, limits);
}

std::variant<NamedPhPath, NotNear> read_path_near(std::string_view text, const Rational& epsilon,
                                                  const CurveLimits& limits) {
  const JsonValue document = parse_json_file(text, "curve file");
  format_of(Node(document));
  return read_path_near(Node(document), epsilon, limits);
}

std::variant<NamedPhPath, NotNear> read_path_near(const JsonNode& node, const Rational& epsilon,
                                                  const CurveLimits& limits) {
  node.require(Kind::object, "an object");
  refuse_long_numbers(node);
  const std::string format = node.find("phrame") ? format_of(node) : "curve/1";
  std::optional<NearReading> near;
  if (format == "spline/1") near = read_spline_near(node, epsilon, limits);
  if (format == "curve/1") near = read_curve_near(node, epsilon, limits);
  if (near) return *std::move(near);
  return read_path(node, limits);
}

std::string curve_file_format(std::string_view text) {
  const auto start = text.find_first_not_of(" \t\r\n");
  if (start == std::string_view::npos || text[start] != '{') return "";
  const JsonValue document = parse_json_file(text, "curve file");
  const auto format = Node(document).find("phrame");
  if (!format || !format->is(Kind::string)) return "";
  const std::string& name = format->string();
  return name == "curve/1" || name == "spline/1" ? name : "";
}

std::optional<NamedRationalCurve> read_rational_curve(std::string_view text,
                                                      const CurveLimits& limits) {
  const JsonValue document = parse_json_file(text, "curve file");
  const Node node(document);
  require_curve(node);
  refuse_long_numbers(node);
  std::optional<RationalCurve> curve;
  if (is_given_as_rational(node)) {
    curve = given_positions(node, limits);
  } else if (!node.find("control_points")) {
    const Curve ph = read_preimage_curve(node, limits).curve;
    if (!ph.is_polynomial()) curve = PhSegment(ph).by_positions();
  }
  if (!curve || curve->weight().is_constant()) return std::nullopt;
  return NamedRationalCurve{read_name(node), *std::move(curve)};
}

NamedHodograph read_hodograph(std::string_view text, const CurveLimits& limits) {
  const JsonValue document = parse_json_file(text, "curve file");
  const Node node(document);
  require_curve(node);
  refuse_long_numbers(node);
  if (is_given_as_rational(node)) {
    const RationalCurve curve = given_positions(node, limits);
    if (!curve.weight().is_constant()) refuse_rational(node);
    return hodograph_of(node, curve);
  }
  if (const auto points = node.find("control_points")) return read_bezier(node, *points, limits);
  const NamedCurve named = read_preimage_curve(node, limits);
  if (!named.curve.is_polynomial()) refuse_rational(node);
  return {named.name, hodograph(named.curve), named.curve.start()};
}

}  // namespace phrame
