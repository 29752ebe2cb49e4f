#include "phrame/io/read/rational_node.hpp"

#include <fmt/format.h>

#include "phrame/algebra/as_written.hpp"
#include "phrame/algebra/error.hpp"
#include "phrame/io/read/bspline_node.hpp"
#include "phrame/io/read/curve_node.hpp"
#include "phrame/io/read/expression_node.hpp"

namespace phrame::inline v0 {
namespace {

/// What a curve that is given by `key` has none of.
void refuse_keys_beside(const JsonNode& node, std::string_view key,
                        std::initializer_list<const char*> others) {
  for (const char* other : others)
    if (node.find(other))
      node.fail(fmt::format("\"{}\" and \"{}\" exclude each other", key, other));
}

/// The numbers at "weights", > 0, as many as there are points.
std::vector<Rational> weights_at(const JsonNode& list, std::size_t count) {
  list.require(JsonNode::Kind::array, "an array of numbers");
  if (list.size() != count)
    list.fail(fmt::format("{} weights for {} control points", list.size(), count));
  std::vector<Rational> weights = list.numbers();
  for (std::size_t k = 0; k < count; ++k)
    if (weights[k] <= 0)
      list.item(k).fail(fmt::format("the weight {} is not greater than 0", as_written(weights[k])));
  return weights;
}

GivenSegment read_bezier_segment(const JsonNode& node, const JsonNode& list,
                                 const CurveLimits& limits) {
  refuse_keys_beside(node, "control_points", {"position"});
  read_bezier(node, list, limits);
  RationalBezier bezier{read_points_of_any_dimension(list), {}};
  if (const auto weights = node.find("weights"))
    bezier.weights = weights_at(*weights, bezier.points.size());
  return bezier_segment(bezier, node.place());
}

GivenSegment read_position_segment(const JsonNode& node, const JsonNode& position,
                                   const CurveLimits& limits) {
  refuse_keys_beside(
      node, "position",
      {"preimage", "quaternions", "hopf", "complex", "tangents", "multiplier", "start", "weights"});
  const CoefficientBasis basis(node, limits);
  position.require_known_keys({"x", "y", "z", "w"});
  std::vector<JsonNode> lists{position.at("x"), position.at("y")};
  const bool has_z = position.find("z").has_value();
  if (has_z) lists.push_back(position.at("z"));
  if (const auto w = position.find("w")) lists.push_back(*w);
  basis.require_equal_lengths(position, lists);
  Vector<Polynomial> numerator;
  for (std::size_t c = 0; c < (has_z ? 3 : 2); ++c) numerator[c] = basis.polynomial(lists[c]);
  const auto w = position.find("w");
  try {
    return {RationalCurve(numerator, w ? basis.polynomial(*w) : Polynomial{1}), node.place()};
  } catch (const DomainError& error) {
    position.fail(error.what());
  }
}

}  // namespace

GivenSegment read_curve_segment(const JsonNode& node, const CurveLimits& limits) {
  require_curve_keys(node);
  if (const auto expressions = node.find("expressions"))
    return read_expression_segment(node, *expressions);
  for (const char* of_expressions : {"variable", "from", "to"})
    if (const auto given = node.find(of_expressions))
      given->fail("this is of \"expressions\", which are missing");
  if (const auto list = node.find("control_points"))
    return read_bezier_segment(node, *list, limits);
  if (const auto position = node.find("position"))
    return read_position_segment(node, *position, limits);
  if (const auto weights = node.find("weights"))
    weights->fail("weights are those of \"control_points\", which are missing");
  return {read_preimage_curve(node, limits).curve, node.place()};
}

}  // namespace phrame
