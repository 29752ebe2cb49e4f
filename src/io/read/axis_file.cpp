#include "phrame/io/read/axis_file.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "phrame/algebra/error.hpp"
#include "phrame/io/read/curve_node.hpp"
#include "phrame/ph/curve/vector.hpp"

namespace phrame::inline v0 {
namespace {

using Node = JsonNode;

struct RadialHodograph {
  Vector<Polynomial> hodograph;
  Vector<Rational> start;
};

Vector<Polynomial> polynomials(const Node& node, const CoefficientBasis& basis) {
  const std::vector<Node> lists{node.at("x"), node.at("y"), node.at("r")};
  basis.require_equal_lengths(node, lists);
  return {basis.polynomial(lists[0]), basis.polynomial(lists[1]), basis.polynomial(lists[2])};
}

RadialHodograph read_radial_preimage(const Node& node, const CurveLimits& limits,
                                     const MedialAxis& before) {
  const CoefficientBasis basis(node, limits);
  MinkowskiCurve curve{read_components(node.at("preimage"), basis), {1}, {}};
  if (const auto list = node.find("multiplier")) {
    basis.require_list(*list);
    curve.multiplier = basis.polynomial(*list);
  }
  if (const auto start = node.find("start"))
    curve.start = read_point(*start);
  else if (before.empty())
    node.at("start");
  else
    curve.start = evaluate(position(before.back()), 1);
  return {curve.multiplier * direction(curve), curve.start};
}

RadialHodograph read_radial(const Node& node, const CurveLimits& limits, const MedialAxis& before) {
  if (const auto points = node.find("control_points")) {
    for (const char* key : {"x", "y", "r", "preimage", "multiplier", "start"})
      if (node.find(key))
        node.fail(fmt::format("\"control_points\" and \"{}\" exclude each other", key));
    const NamedHodograph bezier = read_bezier(node, *points, limits);
    return {bezier.hodograph, bezier.start};
  }
  if (node.find("preimage")) return read_radial_preimage(node, limits, before);
  if (!node.find("x"))
    node.fail(
        "a curve with radii needs \"control_points\", \"preimage\", or \"x\", \"y\" and \"r\"");
  const Vector<Polynomial> r = polynomials(node, CoefficientBasis(node, limits));
  return {differentiate(r), evaluate(r, 0)};
}

void add_segment(MedialAxis& axis, const Node& node, const CurveLimits& limits) {
  const auto [hodograph, start] = read_radial(node, limits, axis);
  if (hodograph == Vector<Polynomial>{}) node.fail("all discs are one, so that there is no curve");
  long degree = 0;
  for (const Polynomial& x : hodograph) degree = std::max(degree, x.degree() + 1);
  if (degree > limits.max_degree)
    node.fail(fmt::format("the curve has degree {}, the limit is {}; --max-degree raises it",
                          degree, limits.max_degree));
  auto found = identify_minkowski(hodograph, start);
  if (const auto* reason = std::get_if<NotMinkowski>(&found))
    node.fail((reason->number == 0 ? "" : "this is no Minkowski PH curve: ") + to_string(*reason));
  axis.push_back(std::get<MinkowskiCurve>(std::move(found)));
}

}  // namespace

NamedAxis read_axis(std::string_view text, const CurveLimits& limits) {
  const JsonValue document = parse_json_file(text, "curve file");
  const Node node(document);
  require_format(node, "mph/1");
  refuse_long_numbers(node);
  NamedAxis axis{read_name(node), {}};
  const auto segments = node.find("segments");
  if (!segments) {
    node.require_known_keys({"phrame", "name", "note", "basis", "control_points", "x", "y", "r",
                             "preimage", "multiplier", "start"});
    add_segment(axis.segments, node, limits);
    return axis;
  }
  node.require_known_keys({"phrame", "name", "note", "segments"});
  segments->require(JsonValue::Kind::array, "an array of curves with radii");
  if (segments->size() == 0) segments->fail("there is at least one segment");
  for (std::size_t k = 0; k < segments->size(); ++k) {
    const Node item = segments->item(k);
    item.require(JsonValue::Kind::object, "an object");
    item.require_known_keys(
        {"basis", "control_points", "x", "y", "r", "preimage", "multiplier", "start"});
    add_segment(axis.segments, item, limits);
  }
  return axis;
}

}  // namespace phrame
