#include "phrame/io/read/godot_file.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <optional>

#include "phrame/algebra/error.hpp"
#include "phrame/algebra/real.hpp"
#include "phrame/io/read/curve_choice.hpp"
#include "phrame/io/read/number.hpp"
#include "phrame/io/read/svg_number.hpp"
#include "phrame/io/write/text.hpp"
#include "phrame/ph/curve/vector.hpp"

namespace phrame::inline v0 {
namespace {

constexpr std::size_t nowhere = std::string_view::npos;

/// The value of name="…" in a header in brackets; empty where there is none.
std::string attribute(std::string_view header, std::string_view name) {
  const std::string start = fmt::format(" {}=\"", name);
  const auto at = header.find(start);
  if (at == nowhere) return "";
  header.remove_prefix(at + start.size());
  return std::string(header.substr(0, header.find('"')));
}

/// A curve in the text.
struct Section {
  std::size_t begin;  ///< of what is below its header
  std::size_t end;
  std::size_t dimension;
  CurveLabel label;
};

std::optional<std::size_t> dimension_of(std::string_view type) {
  if (type == "Curve3D") return 3;
  if (type == "Curve2D") return 2;
  return std::nullopt;
}

/// What of a section stands behind "key = ", in its line; empty where that is not there.
std::string_view property(std::string_view text, const Section& section, std::string_view key) {
  std::string_view body = text.substr(section.begin, section.end - section.begin);
  const std::string start = fmt::format("\n{} = ", key);
  const auto at = body.find(start);
  if (at == nowhere) return {};
  body.remove_prefix(at + start.size());
  return trimmed(body.substr(0, body.find('\n')));
}

/// The curves: [sub_resource type="Curve3D" id="…"] or, of a file that is one, [resource].
std::vector<Section> sections_of(std::string_view text) {
  std::vector<Section> all;
  std::optional<std::size_t> of_file;
  for (std::size_t at = 0; at < text.size();) {
    const std::size_t end = std::min(text.find('\n', at), text.size());
    const std::string_view line = trimmed(text.substr(at, end - at));
    const std::size_t next = std::min(text.find("\n[", at), text.size());
    const auto dimension = dimension_of(attribute(line, "type"));
    if (line.starts_with("[gd_resource")) of_file = dimension;
    if (line.starts_with("[sub_resource") && dimension)
      all.push_back({end, next, *dimension, {"", attribute(line, "id")}});
    if (line.starts_with("[resource]") && of_file) all.push_back({end, next, *of_file, {}});
    at = next == text.size() ? next : next + 1;
  }
  for (Section& section : all) {
    std::string_view name = property(text, section, "resource_name");
    if (name.size() >= 2 && name.front() == '"') name = name.substr(1, name.size() - 2);
    section.label.name = name;
    if (section.label.shown().empty()) section.label.id = line_and_column(text, section.begin);
  }
  return all;
}

/// Where the numbers begin of the array with that key; npos where there is none.
std::size_t begin_of_array(std::string_view text, const Section& section, std::string_view key) {
  const auto at = text.find(fmt::format("\"{}\"", key), section.begin);
  if (at >= section.end) return nowhere;
  const auto open = text.find('(', at);
  return open >= section.end ? nowhere : open + 1;
}

std::vector<Rational> read_array(std::string_view text, std::size_t begin) {
  SvgNumbers in(text, begin);
  std::vector<Rational> numbers;
  while (!in.take(')')) {
    if (!in.is_at_number()) in.fail("a number or a parenthesis");
    numbers.push_back(in.number());
    if (bits_of(numbers.back()) > most_number_bits) in.fail("a shorter number");
  }
  return numbers;
}

/// A point of such a curve.
struct Handled {
  Vector<Rational> in;
  Vector<Rational> out;
  Vector<Rational> position;
};

std::vector<Handled> read_handled(std::string_view text, const Section& section) {
  const std::size_t begin = begin_of_array(text, section, "points");
  const std::string place =
      line_and_column(text, std::max<std::size_t>(begin == nowhere ? section.begin : begin, 1));
  if (begin == nowhere) throw InputError(place, "the curve has no \"points\"");
  const std::vector<Rational> numbers = read_array(text, begin);
  const std::size_t d = section.dimension;
  if (numbers.size() % (3 * d) != 0)
    throw InputError(place, fmt::format("{} are no triples of vectors: in, out, position",
                                        counted(numbers.size(), "number")));
  std::vector<Handled> points(numbers.size() / (3 * d));
  for (std::size_t k = 0; k < points.size(); ++k)
    for (std::size_t c = 0; c < d; ++c) {
      points[k].in[c] = numbers[3 * d * k + c];
      points[k].out[c] = numbers[3 * d * k + d + c];
      points[k].position[c] = numbers[3 * d * k + 2 * d + c];
    }
  if (points.size() < 2)
    throw InputError(
        place, fmt::format("{}; a curve needs two at least", counted(points.size(), "point")));
  return points;
}

RationalBezier piece(const Handled& from, const Handled& to) {
  const Vector<Rational> none;
  if (from.out == none && to.in == none) return {{from.position, to.position}};
  return {{from.position, from.position + from.out, to.position + to.in, to.position}};
}

}  // namespace

bool is_godot_file(std::string_view text) {
  text = trimmed(text);
  return text.starts_with("[gd_resource") || text.starts_with("[gd_scene");
}

PointCurve read_godot(std::string_view text, const FileReading& reading) {
  const std::vector<Section> all = sections_of(text);
  if (all.empty()) throw InputError("1:1", "there is no Curve3D and no Curve2D in the file");
  std::vector<CurveLabel> labels;
  for (const Section& section : all) labels.push_back(section.label);
  const Section& section = all[chosen_curve(labels, reading.pick)];
  std::vector<Handled> points = read_handled(text, section);
  if (property(text, section, "closed") == "true") points.push_back(points.front());
  PointCurve curve{section.label.name, {}};
  const std::string place = line_and_column(text, section.begin);
  for (std::size_t k = 0; k + 1 < points.size(); ++k)
    curve.segments.push_back(
        bezier_segment(piece(points[k], points[k + 1]), place,
                       fmt::format("the piece from point {} to {}", k, (k + 1) % points.size())));
  const std::size_t tilts = begin_of_array(text, section, "tilts");
  if (tilts == nowhere) return curve;
  const std::vector<Rational> angles = read_array(text, tilts);
  if (std::ranges::any_of(angles, [](const Rational& x) { return x != 0; }))
    curve.notes.emplace_back("the tilts are left out");
  return curve;
}

}  // namespace phrame
