#include "phrame/io/read/geomdl_file.hpp"

#include <fmt/format.h>

#include "phrame/algebra/error.hpp"
#include "phrame/io/read/bspline_node.hpp"

namespace phrame::inline v0 {

bool is_geomdl_file(const JsonNode& node) {
  return node.is(JsonNode::Kind::object) && node.find("shape") && !node.find("phrame");
}

std::vector<GivenSegment> read_geomdl(const JsonNode& node, const CurveLimits& limits) {
  const JsonNode shape = node.at("shape");
  shape.require(JsonNode::Kind::object, "an object");
  const JsonNode type = shape.at("type");
  if (type.string() != "curve")
    type.fail(fmt::format("a curve is wanted, not a {}", abbreviated(type.string())));
  const JsonNode data = shape.at("data");
  data.require(JsonNode::Kind::array, "an array of curves");
  if (data.size() == 0) data.fail("there is no curve");
  std::vector<GivenSegment> segments;
  for (std::size_t k = 0; k < data.size(); ++k) {
    const JsonNode curve = data.item(k);
    curve.require(JsonNode::Kind::object, "an object");
    const JsonNode points = curve.at("control_points");
    points.require(JsonNode::Kind::object, "an object");
    for (GivenSegment& segment : bspline_segments(
             curve, {"degree", "knotvector"}, points.at("points"), points.find("weights"), limits))
      segments.push_back(std::move(segment));
  }
  return segments;
}

}  // namespace phrame
