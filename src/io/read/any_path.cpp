#include "phrame/io/read/any_path.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "phrame/algebra/error.hpp"
#include "phrame/io/read/bspline_node.hpp"
#include "phrame/io/read/curve_node.hpp"
#include "phrame/io/read/dxf_file.hpp"
#include "phrame/io/read/frame_node.hpp"
#include "phrame/io/read/g2_file.hpp"
#include "phrame/io/read/gcode_file.hpp"
#include "phrame/io/read/geomdl_file.hpp"
#include "phrame/io/read/gltf_file.hpp"
#include "phrame/io/read/godot_file.hpp"
#include "phrame/io/read/iges_file.hpp"
#include "phrame/io/read/npy.hpp"
#include "phrame/io/read/number.hpp"
#include "phrame/io/read/part21.hpp"
#include "phrame/io/read/point_curve.hpp"
#include "phrame/io/read/point_file.hpp"
#include "phrame/io/read/point_table.hpp"
#include "phrame/io/read/polyline_file.hpp"
#include "phrame/io/read/rational_node.hpp"
#include "phrame/io/read/scipy_node.hpp"
#include "phrame/io/read/step_file.hpp"
#include "phrame/io/read/svg_file.hpp"
#include "phrame/io/read/svg_path.hpp"
#include "phrame/io/read/text_table.hpp"
#include "phrame/io/read/three_file.hpp"
#include "phrame/io/read/three_scene.hpp"
#include "phrame/io/write/text.hpp"
#include "phrame/ph/curve/direction_span.hpp"
#include "phrame/ph/curve/transform.hpp"
#include "phrame/ph/curve/vector.hpp"

namespace phrame::inline v0 {
namespace {

using GivenSegments = std::vector<GivenSegment>;

std::string format_at(const JsonNode& node, const char* otherwise) {
  node.require(JsonNode::Kind::object, "an object");
  const auto format = node.find("phrame");
  return format ? format->string() : otherwise;
}

/// A segment of a spline, which goes on where that ends unless it says where it starts.
void append_given(GivenSegments& segments, const JsonNode& node, const CurveLimits& limits) {
  const std::string format = format_at(node, "curve/1");
  if (format == "bspline/1" || format == "nurbs/1") {
    for (GivenSegment& segment : read_bspline(node, limits)) segments.push_back(std::move(segment));
    return;
  }
  if (format != "curve/1")
    node.at("phrame").fail(
        fmt::format("the format of a segment is \"curve/1\", \"bspline/1\" or \"nurbs/1\", not "
                    "\"{}\"",
                    abbreviated(format)));
  GivenSegment segment = read_curve_segment(node, limits);
  const auto* curve = std::get_if<Curve>(&segment.form);
  if (curve != nullptr && !node.find("start") && !node.find("tangents") && !segments.empty())
    segment.form = translated(*curve, end_point(segments.back()) - curve->start());
  segments.push_back(std::move(segment));
}

GivenSegments read_spline_segments(const JsonNode& spline, const CurveLimits& limits) {
  spline.require_known_keys(
      {"phrame", "name", "segments", "frame", "note", "family", "expected", "id", "notes"});
  const JsonNode list = spline.at("segments");
  list.require(JsonNode::Kind::array, "an array of curves");
  if (list.size() == 0) list.fail("a spline has at least one segment");
  GivenSegments segments;
  for (std::size_t k = 0; k < list.size(); ++k) append_given(segments, list.item(k), limits);
  return segments;
}

NamedPath path_of_points(PointCurve read, const CurveLimits& limits) {
  NamedPath path = path_of(read.name, std::move(read.segments), limits.gap);
  path.notes.insert(path.notes.begin(), read.notes.begin(), read.notes.end());
  return path;
}

/// JSON that other programs write; no value of another.
std::optional<NamedPath> read_others_json(const JsonNode& node, const CurveLimits& limits,
                                          const FileReading& reading) {
  reading.refuse_skipping("no table");
  if (is_three_scene(node)) {
    refuse_long_numbers(node);
    return path_of_points(read_three_scene(node, limits, reading), limits);
  }
  if (is_gltf_file(node)) return path_of_points(read_gltf(node, reading), limits);
  reading.refuse_picking("one curve");
  if (is_scipy_curve(node)) {
    refuse_long_numbers(node);
    return path_of_points(read_scipy(node, limits), limits);
  }
  if (is_geomdl_file(node) || is_three_file(node)) refuse_long_numbers(node);
  if (is_geomdl_file(node)) {
    const auto name = node.at("shape").find("name");
    return path_of(name ? name->string() : "", read_geomdl(node, limits), limits.gap);
  }
  if (is_three_file(node)) return path_of("", read_three(node, limits), limits.gap);
  return std::nullopt;
}

NamedPath read_json_path(const JsonNode& node, const CurveLimits& limits) {
  const std::string format = format_at(node, "curve/1");
  refuse_long_numbers(node);
  if (format == "spline/1") {
    NamedPath path = path_of(read_name(node), read_spline_segments(node, limits), limits.gap);
    path.frame = read_frame_through(node, path.path.segments().size());
    return path;
  }
  if (format == "bspline/1" || format == "nurbs/1")
    return path_of(read_name(node), read_bspline(node, limits), limits.gap);
  if (format == "points/1") return path_of_points(read_point_curve(node), limits);
  if (format == "poses/1")
    node.at("phrame").fail("these are poses: phrame construct makes a curve of them");
  if (format != "curve/1")
    node.at("phrame").fail(
        fmt::format("the format is \"curve/1\", \"spline/1\", \"bspline/1\", \"nurbs/1\" or "
                    "\"points/1\", not \"{}\"",
                    abbreviated(format)));
  return path_of(read_name(node), {read_curve_segment(node, limits)}, limits.gap);
}

NamedPath read_json_path(std::string_view text, const CurveLimits& limits,
                         const FileReading& reading) {
  const JsonValue document = parse_json_file(text, "curve file");
  const JsonNode node(document);
  if (auto path = read_others_json(node, limits, reading)) return *std::move(path);
  format_of(node);
  return read_json_path(node, limits);
}

/// Without a byte order mark and blanks.
std::string_view content_of(std::string_view text) {
  text = without_mark(text);
  text.remove_prefix(std::min(text.find_first_not_of(" \t\r\n"), text.size()));
  return text;
}

/// Numbers, or names of columns of which one is that of x, in the first line that says something.
bool is_table(std::string_view text) {
  for (;;) {
    const auto end = std::min(text.find_first_of("\r\n"), text.size());
    const std::string_view line = trimmed(text.substr(0, end));
    if (line.starts_with('#') || (line.empty() && end < text.size())) {
      text.remove_prefix(std::min(end + 1, text.size()));
      continue;
    }
    if (line.empty()) return false;
    constexpr std::string_view first_of_number = "+-.0123456789";
    const auto first = line.find_first_not_of('"');
    if (first != std::string_view::npos &&
        first_of_number.find(line[first]) != std::string_view::npos)
      return true;
    const std::string word = lower_case(line.substr(0, 3));
    if (word == "nan" || word == "inf") return true;
    try {
      return names_positions(header_names(line));
    } catch (const InputError&) {
      return false;  // a quote that is not closed
    }
  }
}

/// Of lines with names and numbers below, that no name is that of x. Throws InputError.
void refuse_other_table(std::string_view content) {
  const auto end = content.find_first_of("\r\n");
  if (content.starts_with('{') || end == std::string_view::npos) return;
  const std::string_view rest = trimmed(content.substr(end));
  const std::string_view second = rest.substr(0, rest.find_first_of("\r\n"));
  std::vector<std::string> names;
  try {
    names = header_names(content.substr(0, end));
    const std::vector<std::string> values = header_names(second);
    if (names.size() < 2 || values.size() != names.size() ||
        std::ranges::none_of(values, [](const std::string& value) {
          return value.find_first_of("0123456789") == 0;
        }))
      return;
  } catch (const InputError&) {
    return;  // a quote that is not closed
  }
  throw InputError("line 1", fmt::format("columns x, y and z, or x and y, are wanted; these are {}",
                                         abbreviated(fmt::format("{}", fmt::join(names, ", ")))));
}

/// Of lists, [t, c, k] is no table; what is no JSON is complained of by whoever reads a table.
bool is_scipy_list(std::string_view text) {
  try {
    const JsonValue document = parse_json(text);
    return is_scipy_curve(JsonNode(document));
  } catch (const InputError&) {
    return false;
  }
}

}  // namespace

NamedPath read_any_path(const JsonNode& node, const CurveLimits& limits,
                        const FileReading& reading) {
  if (auto path = read_others_json(node, limits, reading)) return *std::move(path);
  return read_json_path(node, limits);
}

NamedPath read_any_path(std::string_view text, const CurveLimits& limits,
                        const FileReading& reading) {
  text = without_mark(text);
  const std::string_view content = content_of(text);
  if (is_glb_file(content)) {
    reading.refuse_skipping("an animation");
    return path_of_points(read_glb(content, reading), limits);
  }
  if (is_part21(content)) return path_of_points(read_step(text, reading, limits), limits);
  if (is_iges_file(text)) return path_of_points(read_iges(text, reading, limits), limits);
  if (is_gcode_file(content)) return path_of_points(read_gcode(text, reading), limits);
  if (is_g2_file(content)) {
    reading.refuse_skipping("a curve in G2");
    reading.refuse_picking("a curve in G2");
    return path_of("", read_g2(text, limits), limits.gap);
  }
  if (is_dxf_file(content)) return path_of_points(read_dxf(text, reading, limits), limits);
  const bool is_path = is_path_data(text);
  if (is_godot_file(content)) {
    reading.refuse_skipping("a Bézier curve of Godot");
    return path_of_points(read_godot(text, reading), limits);
  }
  if (is_polyline_file(content)) return path_of_points(read_polyline(text, reading), limits);
  if (content.starts_with('[') && is_scipy_list(content))
    return read_json_path(text, limits, reading);
  if (content.starts_with('[') || NpyTable::is_one(text) || (!is_path && is_table(content))) {
    reading.refuse_picking("a table");
    return path_of_points(read_point_table(text, limits, reading), limits);
  }
  if (content.starts_with('<') || is_path) {
    reading.refuse_skipping("an SVG path");
    if (!is_path) return path_of_points(read_svg(text, reading), limits);
    reading.refuse_picking("an SVG path");
    return path_of("", read_path_data(text, 0, text.size()), limits.gap);
  }
  refuse_other_table(content);
  return read_json_path(text, limits, reading);  // which says what it begins with, if not JSON
}

namespace {

/// JSON of another program, or of phrame with a curve.
bool is_json_curve(std::string_view text) {
  const JsonValue document = parse_json_file(text, "file of points");
  const JsonNode node(document);
  if (!node.is(JsonNode::Kind::object)) return false;
  if (is_three_scene(node) || is_gltf_file(node) || is_scipy_curve(node) || is_geomdl_file(node) ||
      is_three_file(node))
    return true;
  const auto format = node.find("phrame");
  return format && format->is(JsonNode::Kind::string) && format->string() != "points/1";
}

/// Does it hold a curve, and no points?
bool holds_curve(std::string_view content) {
  if (content.starts_with('{')) return is_json_curve(content);
  return is_glb_file(content) || is_part21(content) || is_gcode_file(content) ||
         is_g2_file(content) || is_dxf_file(content) || is_path_data(content) ||
         is_godot_file(content) || is_polyline_file(content) || content.starts_with('<');
}

}  // namespace

GivenPoints read_waypoints(std::string_view text, const FileReading& reading) {
  const std::string_view content = content_of(text);
  if (!holds_curve(content)) {
    reading.refuse_picking("a list of points");
    return read_points(text, reading);
  }
  FileReading of_lines = reading;
  if (is_polyline_file(content)) of_lines.kind = "polyline";
  const NamedPath named = read_any_path(text, {}, of_lines);
  const auto& segments = named.path.segments();
  GivenPoints given;
  given.name = named.name;
  given.notes = named.notes;
  for (const Segment& segment : segments) {
    const RationalCurve* curve = rational_curve(segment);
    if (curve == nullptr || !are_on_a_line(direction_span(segment)))
      throw InputError("", fmt::format("segment {} is no line: points or lines are wanted, and "
                                       "this is a curve already",
                                       given.points.size() + 1));
    given.points.push_back(point(*curve, 0));
  }
  given.points.push_back(point(*rational_curve(segments.back()), 1));
  for (const Real& t : named.parameters)
    if (t.exact()) given.parameters.push_back(*t.exact());
  if (given.parameters.size() != given.points.size()) given.parameters.clear();
  given.notes.push_back(
      fmt::format("the points are the ends of its {}", counted(segments.size(), "line")));
  return given;
}

}  // namespace phrame
