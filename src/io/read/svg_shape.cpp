#include "phrame/io/read/svg_shape.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "phrame/algebra/error.hpp"
#include "phrame/io/read/number.hpp"
#include "phrame/io/read/svg_number.hpp"

namespace phrame::inline v0 {

std::optional<Rational> svg_length(std::string_view text, const SvgAttribute& attribute,
                                   std::string_view name) {
  std::string_view value = trimmed(text.substr(attribute.begin, attribute.end - attribute.begin));
  if (value == "auto") return std::nullopt;
  if (value.ends_with("px")) value.remove_suffix(2);
  if (value.empty())
    throw InputError(line_and_column(text, attribute.begin + 1),
                     fmt::format("{}: a number is expected", name));
  const auto end = value.find_last_of("0123456789.");
  if (end != std::string_view::npos && end + 1 < value.size())
    throw InputError(line_and_column(text, attribute.begin + 1),
                     fmt::format("{}: a length without a unit, or in px, is wanted, not \"{}\"",
                                 name, abbreviated(value)));
  const auto end_of_value = static_cast<std::size_t>(value.data() + value.size() - text.data());
  SvgNumbers in(text.substr(0, end_of_value), attribute.begin);
  return in.number();
}

namespace {

class ShapeReader {
 public:
  ShapeReader(std::string_view text, const SvgAttributes& attribute, const PlaneMap& map,
              const std::string& place)
      : text_(text), attribute_(attribute), map_(map), place_(place) {}

  std::vector<GivenSegment> read(std::string_view element);

 private:
  std::optional<Rational> length(std::string_view name) const;
  Rational length_or_zero(std::string_view name) const {
    return length(name).value_or(Rational(0));
  }
  void add(const RationalBezier& piece);
  void line(const PlaneVector& to) {
    add({{{here_[0], here_[1], 0}, {to[0], to[1], 0}}});
    here_ = to;
  }
  /// A quarter of an ellipse, from the direction of `from` to that of `to`.
  void quarter(const Ellipse& ellipse, const PlaneVector& from, const PlaneVector& to);
  void rectangle();
  void ellipse(const Rational& rx, const Rational& ry);
  void polyline(bool is_closed);

  std::string_view text_;
  const SvgAttributes& attribute_;
  const PlaneMap& map_;
  const std::string& place_;
  PlaneVector here_;
  std::vector<GivenSegment> segments_;
};

std::optional<Rational> ShapeReader::length(std::string_view name) const {
  const auto found = attribute_(name);
  return found ? svg_length(text_, *found, name) : std::nullopt;
}

void ShapeReader::add(const RationalBezier& piece) {
  if (std::all_of(piece.points.begin(), piece.points.end(),
                  [&](const auto& p) { return p == piece.points.front(); }))
    return;
  RationalBezier mapped{{}, piece.weights};
  for (const Vector<Rational>& p : piece.points)
    mapped.points.push_back({p[0] * map_.a[0] + p[1] * map_.b[0] + map_.offset[0],
                             p[0] * map_.a[1] + p[1] * map_.b[1] + map_.offset[1], 0});
  segments_.push_back(bezier_segment(mapped, place_));
}

void ShapeReader::quarter(const Ellipse& ellipse, const PlaneVector& from, const PlaneVector& to) {
  for (const RationalBezier& piece : ellipse_arc(ellipse, from, to, true)) add(piece);
  here_ = {ellipse.center[0] + to[0] * ellipse.a[0], ellipse.center[1] + to[1] * ellipse.b[1]};
}

void ShapeReader::rectangle() {
  const Rational x = length_or_zero("x"), y = length_or_zero("y");
  const Rational w = length_or_zero("width"), h = length_or_zero("height");
  if (w <= 0 || h <= 0) return;
  const auto given_x = length("rx"), given_y = length("ry");
  const Rational rx =
      std::clamp(given_x.value_or(given_y.value_or(0)), Rational(0), Rational(w / 2));
  const Rational ry =
      std::clamp(given_y.value_or(given_x.value_or(0)), Rational(0), Rational(h / 2));
  const bool is_round = rx > 0 && ry > 0;
  const auto corner = [&](const Rational& cx, const Rational& cy, const PlaneVector& from,
                          const PlaneVector& to) {
    if (is_round) quarter({{cx, cy}, {rx, 0}, {0, ry}}, from, to);
  };
  const Rational dx = is_round ? rx : Rational(0), dy = is_round ? ry : Rational(0);
  here_ = {x + dx, y};
  line({x + w - dx, y});
  corner(x + w - rx, y + ry, {0, -1}, {1, 0});
  line({x + w, y + h - dy});
  corner(x + w - rx, y + h - ry, {1, 0}, {0, 1});
  line({x + dx, y + h});
  corner(x + rx, y + h - ry, {0, 1}, {-1, 0});
  line({x, y + dy});
  corner(x + rx, y + ry, {-1, 0}, {0, -1});
}

void ShapeReader::ellipse(const Rational& rx, const Rational& ry) {
  if (rx <= 0 || ry <= 0) return;
  const Ellipse whole{{length_or_zero("cx"), length_or_zero("cy")}, {rx, 0}, {0, ry}};
  for (const RationalBezier& piece : ellipse_arc(whole, {1, 0}, {1, 0}, true)) add(piece);
}

void ShapeReader::polyline(bool is_closed) {
  const auto found = attribute_("points");
  if (!found) return;
  SvgNumbers in(text_.substr(0, found->end), found->begin);
  std::vector<PlaneVector> points;
  while (!in.at_end()) {
    const Rational x = in.number();
    points.push_back({x, in.number()});
  }
  if (points.empty()) return;
  if (is_closed) points.push_back(points.front());
  here_ = points.front();
  for (std::size_t k = 1; k < points.size(); ++k) line(points[k]);
}

std::vector<GivenSegment> ShapeReader::read(std::string_view element) {
  if (element == "rect") rectangle();
  if (element == "circle") ellipse(length_or_zero("r"), length_or_zero("r"));
  if (element == "ellipse") {
    const auto rx = length("rx"), ry = length("ry");
    ellipse(rx.value_or(ry.value_or(0)), ry.value_or(rx.value_or(0)));
  }
  if (element == "line") {
    here_ = {length_or_zero("x1"), length_or_zero("y1")};
    line({length_or_zero("x2"), length_or_zero("y2")});
  }
  if (element == "polyline" || element == "polygon") polyline(element == "polygon");
  return std::move(segments_);
}

}  // namespace

bool is_svg_shape(std::string_view element) {
  constexpr std::array shapes{"rect", "circle", "ellipse", "line", "polyline", "polygon"};
  return std::find(shapes.begin(), shapes.end(), element) != shapes.end();
}

std::vector<GivenSegment> read_svg_shape(std::string_view element, std::string_view text,
                                         const SvgAttributes& attribute, const PlaneMap& map,
                                         const std::string& place) {
  return ShapeReader(text, attribute, map, place).read(element);
}

}  // namespace phrame
