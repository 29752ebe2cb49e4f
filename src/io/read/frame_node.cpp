#include "phrame/io/read/frame_node.hpp"

#include <fmt/format.h>

#include "phrame/algebra/as_written.hpp"
#include "phrame/io/read/curve_node.hpp"

namespace phrame::inline v0 {
namespace {

FrameThrough::Joint read_joint(const JsonNode& node, std::size_t segments) {
  node.require(JsonNode::Kind::object, "an object with t and f2");
  node.require_known_keys({"t", "f2", "turns"});
  const JsonNode at = node.at("t");
  const Rational t = at.number();
  if (denominator(t) != 1 || t < 0 || t > Rational(static_cast<long>(segments)))
    at.fail(fmt::format("{} is no joint, a whole number from 0 to {}", as_written(t), segments));
  FrameThrough::Joint joint{static_cast<std::size_t>(static_cast<long>(numerator(t))),
                            read_point(node.at("f2"))};
  if (const auto turns = node.find("turns")) joint.turns = read_turns(*turns);
  return joint;
}

}  // namespace

long read_turns(const JsonNode& node) {
  const Rational turns = node.number();
  constexpr long most = 1'000'000;
  if (denominator(turns) != 1 || abs(turns) > most)
    node.fail(fmt::format("{} is no whole number of turns, at most a million", as_written(turns)));
  return static_cast<long>(numerator(turns));
}

std::optional<FrameThrough> read_frame_through(const JsonNode& spline, std::size_t segments) {
  const auto node = spline.find("frame");
  if (!node) return std::nullopt;
  node->require(JsonNode::Kind::object, "an object with through");
  node->require_known_keys({"through", "twist", "tangent_axis"});
  FrameThrough frame;
  const JsonNode list = node->at("through");
  list.require(JsonNode::Kind::array, "an array of orientations");
  for (std::size_t k = 0; k < list.size(); ++k) {
    frame.joints.push_back(read_joint(list.item(k), segments));
    if (k > 0 && frame.joints[k].joint <= frame.joints[k - 1].joint)
      list.item(k).at("t").fail("it is not greater than that before it");
  }
  if (list.size() < 2 || frame.joints.front().joint != 0 || frame.joints.back().joint != segments)
    list.fail(fmt::format("there is none at both ends, t = 0 and {}", segments));
  frame.is_smooth = word_at(*node, "twist", false, {{"even", false}, {"smooth", true}});
  frame.axis = word_at(*node, "tangent_axis", TangentAxis(), tangent_axes());
  return frame;
}

}  // namespace phrame
