#include "phrame/io/read/bspline_node.hpp"

#include <fmt/format.h>

#include "phrame/algebra/as_written.hpp"
#include "phrame/algebra/error.hpp"
#include "phrame/io/read/curve_node.hpp"
#include "phrame/io/write/text.hpp"

namespace phrame::inline v0 {
namespace {

/// A whole number from 1 to `most`.
long read_count(const JsonNode& node, long most, const std::string& what) {
  const Rational number = node.number();
  if (denominator(number) != 1)
    node.fail(fmt::format("the {} {} is no whole number", what, as_written(number)));
  if (number < 1) node.fail(fmt::format("the {} {} is less than 1", what, as_written(number)));
  if (number > most)
    node.fail(fmt::format("the {} {} is beyond {}", what, as_written(number), most));
  return static_cast<long>(numerator(number));
}

/// Each knot as often as it counts; `index` tells of which entry each is.
struct KnotList {
  std::vector<Rational> knots;
  std::vector<std::size_t> index;
};

KnotList read_knots(const JsonNode& list, const std::optional<JsonNode>& multiplicities,
                    long degree) {
  list.require(JsonNode::Kind::array, "an array of knots");
  const std::vector<Rational> given = list.numbers();
  if (multiplicities) {
    multiplicities->require(JsonNode::Kind::array, "an array of whole numbers");
    if (multiplicities->size() != given.size())
      multiplicities->fail(fmt::format("{} multiplicities for {}", multiplicities->size(),
                                       counted(given.size(), "knot")));
  }
  KnotList result;
  for (std::size_t k = 0; k < given.size(); ++k) {
    if (multiplicities && k > 0 && given[k] == given[k - 1])
      list.item(k).fail("the knot is that before it, which \"multiplicities\" should say");
    const long count =
        multiplicities ? read_count(multiplicities->item(k), degree + 1, "multiplicity") : 1;
    for (long j = 0; j < count; ++j) {
      result.knots.push_back(given[k]);
      result.index.push_back(k);
    }
  }
  return result;
}

}  // namespace

std::vector<Vector<Rational>> read_points_of_any_dimension(const JsonNode& list) {
  list.require(JsonNode::Kind::array, "an array of points");
  std::vector<Vector<Rational>> points;
  std::size_t dimension = 0;
  for (std::size_t k = 0; k < list.size(); ++k) {
    const JsonNode item = list.item(k);
    item.require(JsonNode::Kind::array, "an array of 2 or 3 numbers");
    if (item.size() != 2 && item.size() != 3)
      item.fail(fmt::format("a point has 2 or 3 coordinates, not {}", item.size()));
    if (k == 0) dimension = item.size();
    if (item.size() != dimension)
      item.fail(fmt::format("{} here, but {} in the first point", counted(item.size(), "number"),
                            dimension));
    Vector<Rational> point;
    for (std::size_t c = 0; c < dimension; ++c) point[c] = item.item(c).number();
    points.push_back(point);
  }
  return points;
}

long read_degree(const JsonNode& node, const CurveLimits& limits) {
  const Rational given = node.number();
  if (given > limits.max_degree)
    node.fail(fmt::format("the degree {} is beyond the limit {}; --max-degree raises it",
                          as_written(given), limits.max_degree));
  return read_count(node, limits.max_degree, "degree");
}

std::vector<GivenSegment> bspline_segments(const JsonNode& node, const BSplineKeys& keys,
                                           const JsonNode& points,
                                           const std::optional<JsonNode>& weights,
                                           const CurveLimits& limits) {
  BSpline spline;
  const JsonNode degree = node.at(keys.degree);
  spline.degree = read_degree(degree, limits);
  spline.points = read_points_of_any_dimension(points);
  const JsonNode knots = node.at(keys.knots);
  const KnotList list = read_knots(knots, node.find("multiplicities"), spline.degree);
  spline.knots = list.knots;
  if (weights) {
    weights->require(JsonNode::Kind::array, "an array of numbers");
    spline.weights = weights->numbers();
    if (spline.weights.empty()) weights->fail("the list of weights is empty");
  }
  if (const auto fault = fault_of(spline)) {
    using Member = BSplineFault::Member;
    const auto fail_in = [&](const JsonNode& where, std::size_t index) {
      (fault->index ? where.item(index) : where).fail(fault->reason);
    };
    const std::size_t at = fault->index.value_or(0);
    if (fault->member == Member::degree) fail_in(degree, at);
    if (fault->member == Member::points) fail_in(points, at);
    if (fault->member == Member::weights) fail_in(*weights, at);
    // Of a list without its outermost knots, too, the index is that of the list.
    fail_in(knots, fault->index ? list.index[at] : 0);
  }
  return span_segments(spline, knots.place());
}

std::vector<GivenSegment> read_bspline(const JsonNode& node, const CurveLimits& limits) {
  node.require_known_keys(
      {"phrame", "name", "degree", "knots", "multiplicities", "control_points", "weights", "note"});
  const auto weights = node.find("weights");
  if (node.at("phrame").string() == "bspline/1" && weights)
    weights->fail("a B-spline has no weights; with them its format is \"nurbs/1\"");
  return bspline_segments(node, {}, node.at("control_points"), weights, limits);
}

}  // namespace phrame
