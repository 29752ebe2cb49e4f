#include "phrame/io/read/pose_file.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "phrame/algebra/error.hpp"
#include "phrame/io/read/curve_node.hpp"
#include "phrame/io/read/frame_node.hpp"
#include "phrame/io/read/frames_of_table.hpp"
#include "phrame/io/read/point_file.hpp"
#include "phrame/io/read/point_table.hpp"
#include "phrame/io/write/text.hpp"
#include "phrame/ph/curve/vector.hpp"

namespace phrame::inline v0 {
namespace {

using Node = JsonNode;
using Axes = std::array<Vector<Rational>, 3>;

constexpr const char* no_rotation =
    "this is no rotation: its axes are not orthogonal and of length 1 to within 1/100, or "
    "left-handed";

/// The third axis of two.
void complete(std::array<std::optional<Vector<Rational>>, 3>& axes) {
  for (std::size_t k = 0; k < 3; ++k)
    if (!axes[k] && axes[(k + 1) % 3] && axes[(k + 2) % 3])
      axes[k] = cross(*axes[(k + 1) % 3], *axes[(k + 2) % 3]);
}

Orientation orientation_of(const Axes& columns, const std::string& place) {
  if (auto found = nearest_rotation(columns)) return *std::move(found);
  throw InputError(place, no_rotation);
}

Axes transposed(const Axes& m) {
  Axes result;
  for (std::size_t i = 0; i < 3; ++i)
    for (std::size_t j = 0; j < 3; ++j) result[i][j] = m[j][i];
  return result;
}

Orientation read_quaternion(const Node& node, FrameReading::Quaternion order, bool is_inverse) {
  const auto q = node.numbers(4);
  RationalQuaternion p{q[3], q[0], q[1], q[2]};
  if (order == FrameReading::Quaternion::wxyz) p = {q[0], q[1], q[2], q[3]};
  if (norm(p) == 0) node.fail("the quaternion is 0, which is no rotation");
  return {is_inverse ? conjugate(p) : p, 0};
}

Orientation read_orientation(const Node& node, FrameReading::Quaternion order, bool is_inverse) {
  if (node.is(Node::Kind::object)) {
    node.require_known_keys({"e1", "e2", "e3"});
    std::array<std::optional<Vector<Rational>>, 3> axes;
    for (std::size_t k = 0; k < 3; ++k)
      if (const auto axis = node.find(fmt::format("e{}", k + 1))) axes[k] = read_point(*axis);
    complete(axes);
    if (!axes[0] || !axes[1] || !axes[2]) node.fail("two of the axes e1, e2 and e3 are wanted");
    const Axes columns{*axes[0], *axes[1], *axes[2]};
    return orientation_of(is_inverse ? transposed(columns) : columns, node.place());
  }
  node.require(Node::Kind::array, "an array of 4 numbers, or of 3 rows of a matrix,");
  if (node.size() == 4) return read_quaternion(node, order, is_inverse);
  if (node.size() != 3)
    node.fail(fmt::format("{} here: a quaternion has 4 numbers, a matrix 3 rows",
                          counted(node.size(), "item")));
  const Axes rows{read_point(node.item(0)), read_point(node.item(1)), read_point(node.item(2))};
  return orientation_of(is_inverse ? rows : transposed(rows), node.place());
}

GivenPoints read_json(const Node& node, const PoseReading& reading) {
  node.require_known_keys({"phrame", "name", "note", "points", "orientations", "order",
                           "tangent_axis", "parameters", "turns", "twist"});
  require_format(node, "poses/1");
  refuse_long_numbers(node);
  GivenPoints given;
  given.name = read_name(node);
  const Node points = node.at("points");
  points.require(Node::Kind::array, "an array of points");
  if (points.size() < 2)
    points.fail(fmt::format("{}; a curve needs two at least", counted(points.size(), "pose")));
  for (std::size_t k = 0; k < points.size(); ++k)
    given.points.push_back(read_point(points.item(k)));
  const Node orientations = node.at("orientations");
  orientations.require(Node::Kind::array, "an array of orientations");
  const auto require_count = [&](const Node& list, std::size_t least, std::size_t most) {
    if (list.size() < least || list.size() > most)
      list.fail(fmt::format("{} for {}", list.size(), counted(points.size(), "point")));
  };
  require_count(orientations, points.size(), points.size());
  using Quaternion = FrameReading::Quaternion;
  const Quaternion order = reading.quaternion.value_or(word_at(
      node, "order", Quaternion::xyzw, {{"xyzw", Quaternion::xyzw}, {"wxyz", Quaternion::wxyz}}));
  GivenPoses poses;
  for (std::size_t k = 0; k < orientations.size(); ++k)
    poses.bodies.push_back(read_orientation(orientations.item(k), order, reading.is_inverse));
  poses.tangent = word_at(node, "tangent_axis", TangentAxis(), tangent_axes());
  poses.is_smooth = word_at(node, "twist", false, {{"even", false}, {"smooth", true}});
  if (const auto list = node.find("turns")) {
    list->require(Node::Kind::array, "an array of whole numbers");
    require_count(*list, points.size() - 1, points.size());
    for (std::size_t k = 0; k < list->size(); ++k) poses.turns.push_back(read_turns(list->item(k)));
  }
  if (const auto list = node.find("parameters")) {
    given.parameters = list->numbers();
    require_count(*list, points.size(), points.size() + 1);
  }
  given.poses = std::move(poses);
  require_meaning(
      given, [](std::string_view list, std::size_t k) { return fmt::format("/{}/{}", list, k); });
  return given;
}

/// The axes x, y, z of the body; the tangent of the table is x.
Axes axes_of(const GivenFrame& frame, const std::string& place) {
  std::array<std::optional<Vector<Rational>>, 3> axes{frame.tangent, frame.f2, frame.f3};
  complete(axes);
  if (!axes[0] || !axes[2])
    throw InputError(place, "f2 alone is no orientation: f3 or e1 is wanted as well");
  return {*axes[0], *axes[1], *axes[2]};
}

GivenPoints read_table(std::string_view bytes, const PoseReading& wanted,
                       const FileReading& reading) {
  PointTable rows = read_points_of_table(bytes, reading);
  GivenPoints given = std::move(rows.given);
  FrameReading frames;
  frames.is_inverse = wanted.is_inverse;
  frames.skips_invalid = reading.skips_invalid;
  frames.quaternion = wanted.quaternion.value_or(FrameReading::Quaternion::named);
  if (rows.table->names().empty() && rows.table->columns() == 8 && !wanted.quaternion)
    frames.quaternion = FrameReading::Quaternion::xyzw;
  // Of the rows that are points; one without an orientation leaves fewer of these.
  std::vector<std::string> places;
  for (std::size_t k = 0; k < rows.table->rows(); ++k) places.push_back(rows.table->place(k));
  const GivenTable read = frames_of_table(std::move(rows.table), frames);
  if (read.frames.size() != given.points.size())
    throw InputError(
        fmt::format("{} with orientations, but {} points: rows without numbers, or "
                    "at the place of the one before them, are not left out of poses",
                    counted(read.frames.size(), "row"), given.points.size()));
  GivenPoses poses;
  for (std::size_t k = 0; k < read.frames.size(); ++k) {
    poses.bodies.push_back(orientation_of(axes_of(read.frames[k], places[k]), places[k]));
  }
  given.poses = std::move(poses);
  given.tangents.clear();
  given.derivatives.clear();
  // Those of an orientation have been read.
  std::erase_if(given.skipped_columns, [](const std::string& name) {
    return name.size() > 1 && (name.starts_with("q") || name.starts_with("f2") ||
                               name.starts_with("f3") || name.starts_with("e1"));
  });
  return given;
}

/// JSON that begins with a '{'; no value of another text.
std::optional<JsonValue> object_of(std::string_view bytes) {
  const auto first = bytes.find_first_not_of(" \t\r\n", bytes.starts_with("\xEF\xBB\xBF") ? 3 : 0);
  if (first == std::string_view::npos || bytes[first] != '{') return std::nullopt;
  return parse_json_file(bytes, "file of points");
}

bool are_poses(const Node& node) {
  const auto format = node.find("phrame");
  return format && format->is(Node::Kind::string) && format->string() == "poses/1";
}

}  // namespace

bool is_pose_file(std::string_view bytes) {
  const auto document = object_of(bytes);
  return document && are_poses(Node(*document));
}

GivenPoints read_poses(std::string_view bytes, const PoseReading& poses,
                       const FileReading& reading) {
  const auto document = object_of(bytes);
  if (document && !are_poses(Node(*document)))
    throw InputError("/phrame", "orientations are in tables and in the format \"poses/1\"");
  if (document) reading.refuse_skipping("poses/1");
  GivenPoints given =
      document ? read_json(Node(*document), poses) : read_table(bytes, poses, reading);
  if (poses.tangent) given.poses->tangent = *poses.tangent;
  if (!poses.turns.empty()) given.poses->turns = poses.turns;
  given.poses->is_smooth = given.poses->is_smooth || poses.is_smooth;
  return given;
}

}  // namespace phrame
