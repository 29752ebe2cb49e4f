#include "phrame/io/read/profile.hpp"
#include "phrame/io/read/profile_curve.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "phrame/algebra/as_written.hpp"
#include "phrame/algebra/error.hpp"
#include "phrame/algebra/rounding.hpp"
#include "phrame/io/read/number.hpp"
#include "phrame/io/read/svg_file.hpp"
#include "phrame/io/read/svg_path.hpp"
#include "phrame/io/read/text_table.hpp"
#include "phrame/ph/curve/curve_series.hpp"
#include "phrame/ph/sweep/profile_apart.hpp"

namespace phrame::inline v0 {
namespace {

/// What may go wrong with the corners is about the file.
template <class Make>
auto made(Make make) {
  try {
    return make();
  } catch (const DomainError& error) {
    throw InputError(error.what());
  }
}

std::vector<Rational> numbers_of(std::string_view text) {
  std::vector<Rational> numbers;
  for (std::size_t from = 0; from <= text.size();) {
    const std::size_t comma = std::min(text.find(',', from), text.size());
    numbers.push_back(parse_short_number(text.substr(from, comma - from)));
    from = comma + 1;
  }
  return numbers;
}

CurveSeries series_of_segment(const GivenSegment& segment) {
  if (const auto* curve = std::get_if<Curve>(&segment.form)) return series_of(PhPath(*curve));
  if (const auto* curve = std::get_if<RationalCurve>(&segment.form)) return series_of(Path(*curve));
  return series_of(Path(std::get<ExpressionCurve>(segment.form)));
}

constexpr long bits = 96;

/// Of a Taylor coefficient in the plane.
RealBall plane_length(const Vector<BallPolynomial>& r, long order) {
  RealBall sum;
  for (std::size_t k = 0; k < 2; ++k) {
    const RealBall x = absolute(r[k].coefficient(order));
    sum = add(sum, multiply(x, x, bits), bits);
  }
  return sqrt_of_nonnegative(sum, bits);
}

/// As far as (Δt)²/8·|r″| the chord of a part is from it; and it is parallel to one of the
/// tangents, which turn by Δt·|r″|/|r′| at most.
bool is_flat(const CurveSeries& series, const Rational& from, const Rational& to,
             const ProfileTolerance& tolerance) {
  const auto r = series.position(0, hull(from, to, bits), 3, bits);
  const RealBall second = plane_length(r, 2);  // r″ is twice the coefficient
  const Rational step = to - from;
  const auto is_less = [](const RealBall& a, const RealBall& b) {
    return sign(subtract(b, a, bits)) > 0;
  };
  if (!is_less(multiply(RealBall(step * step / 4, bits), second, bits),
               RealBall(*tolerance.distance, bits)))
    return false;
  return !tolerance.angle ||
         is_less(multiply(RealBall(2 * step, bits), second, bits),
                 multiply(RealBall(*tolerance.angle, bits), plane_length(r, 1), bits));
}

/// The corners along a segment, without its end.
void add_corners(std::vector<ProfilePoint>& corners, const GivenSegment& segment,
                 const ProfileTolerance& tolerance) {
  const CurveSeries series = series_of_segment(segment);
  std::vector<std::pair<Rational, Rational>> left{{0, 1}};
  while (!left.empty()) {
    const auto [from, to] = left.back();
    left.pop_back();
    if (!is_flat(series, from, to, tolerance)) {
      if (corners.size() + left.size() > 10'000)
        throw InputError("the tolerance is too small: more than 10000 corners are needed");
      const Rational middle = (from + to) / 2;
      left.emplace_back(middle, to);
      left.emplace_back(from, middle);
      continue;
    }
    const auto r = series.position(0, RealBall(from, bits), 1, bits);
    corners.push_back({exact_rational(approximate(r[0].coefficient(0))),
                       -exact_rational(approximate(r[1].coefficient(0)))});
  }
}

/// The greatest coordinate of the ends of the segments.
Rational size_of(const std::vector<GivenSegment>& segments) {
  Rational size;
  for (const GivenSegment& segment : segments)
    for (const Rational& x : end_point(segment)) size = std::max<Rational>(size, abs(x));
  return size;
}

/// Where the corners of a polygon are moved by so much, its sides turn by no more than this.
Rational rounding_angle(const std::vector<ProfilePoint>& corners, const Rational& moved) {
  Rational least = -1;
  for (std::size_t k = 0; k < corners.size(); ++k) {
    const auto& [x, y] = corners[k];
    const auto& [next_x, next_y] = corners[(k + 1) % corners.size()];
    const Rational side = std::max<Rational>(abs(next_x - x), abs(next_y - y));
    if (least < 0 || side < least) least = side;
  }
  return least > 0 ? Rational(4 * moved / least) : Rational(4);
}

/// A closed curve; a line closes one that is not.
using Subpath = std::vector<GivenSegment>;

std::vector<ProfilePoint> corners_of(const Subpath& segments, const ProfileTolerance& half) {
  std::vector<ProfilePoint> corners;
  for (const GivenSegment& segment : segments) add_corners(corners, segment, half);
  const Vector<Rational> end = end_point(segments.back());
  const ProfilePoint last{exact_rational(round_to_double(end[0])),
                          -exact_rational(round_to_double(end[1]))};
  if (!corners.empty() && last != corners.front()) corners.push_back(last);
  return corners;
}

Profile outline_of(const std::vector<Subpath>& subpaths, const ProfileTolerance& asked) {
  Rational size;
  for (const Subpath& segments : subpaths) size = std::max<Rational>(size, size_of(segments));
  const Rational tolerance = asked.distance.value_or(size / 1000);
  ProfileTolerance half{tolerance / 2, asked.angle};
  if (half.angle) *half.angle /= 2;
  // Corners are rounded to doubles, and a curve may go twice as far as its ends.
  const Rational moved = size * power_of_two(-48);
  Rational turned;
  std::vector<std::vector<ProfilePoint>> rings;
  for (const Subpath& segments : subpaths) {
    rings.push_back(corners_of(segments, half));
    turned = std::max(turned, rounding_angle(rings.back(), moved));
  }
  const Rational angle = half.angle ? *half.angle + turned : Rational(4);
  return made([&] { return Profile::of_rings(std::move(rings), tolerance / 2 + moved, angle); });
}

/// y is up.
PlaneRational plane_form(const GivenSegment& segment) {
  if (const auto* curve = std::get_if<Curve>(&segment.form)) {
    const auto r = position(*curve);
    return {r[0], -r[1], {1}};
  }
  const auto* curve = std::get_if<RationalCurve>(&segment.form);
  if (curve == nullptr) throw InputError(segment.place, "it is no rational curve");
  return {curve->numerator()[0], -curve->numerator()[1], curve->weight()};
}

std::vector<PlaneBezier> pieces_of(const Subpath& segments) {
  std::vector<PlaneBezier> pieces;
  for (const GivenSegment& segment : segments)
    for (PlaneBezier& piece : bezier_pieces(plane_form(segment)))
      pieces.push_back(std::move(piece));
  const ProfilePoint first = pieces.front().points.front();
  const ProfilePoint last = pieces.back().points.back();
  if (first != last) pieces.push_back({{last, first}, {1, 1}});
  return pieces;
}

ProfileCurve outline_curve_of(const std::vector<Subpath>& subpaths) {
  std::vector<std::vector<PlaneBezier>> rings;
  for (const Subpath& segments : subpaths) rings.push_back(pieces_of(segments));
  const ProfileCurve curve = made([&] { return ProfileCurve::of_rings(std::move(rings)); });
  require_rings_apart(curve);
  return curve;
}

/// The subpaths of path data or of an SVG file; no value for what begins as neither.
std::optional<std::vector<Subpath>> svg_subpaths(std::string_view bytes) {
  if (is_path_data(bytes)) return read_subpaths(bytes, 0, bytes.size());
  const std::size_t first = bytes.find_first_not_of(" \t\r\n\xEF\xBB\xBF");
  if (first == std::string_view::npos || bytes[first] != '<') return std::nullopt;
  return read_svg_subpaths(bytes);
}

}  // namespace

std::optional<Profile> parse_profile(std::string_view text, const ProfileTolerance& tolerance) {
  const std::size_t colon = text.find(':');
  if (colon == std::string_view::npos) return std::nullopt;
  const std::string_view word = text.substr(0, colon);
  if (word != "circle" && word != "polygon" && word != "rectangle") return std::nullopt;
  const std::vector<Rational> numbers = numbers_of(text.substr(colon + 1));
  const std::size_t expected = word == "circle" ? 1 : 2;
  if (numbers.size() != expected)
    throw InputError(fmt::format("{} needs {}, not {} numbers", word,
                                 word == "circle"    ? "a radius"
                                 : word == "polygon" ? "the number of corners and a radius"
                                                     : "a width and a height",
                                 numbers.size()));
  return made([&] {
    if (word == "circle")
      return circle_profile(numbers[0], tolerance.distance.value_or(numbers[0] / 1000),
                            tolerance.angle);
    if (word == "rectangle") return rectangle_profile(numbers[0], numbers[1]);
    if (denominator(numbers[0]) != 1 || numbers[0] < 3 || numbers[0] > 10'000)
      throw InputError(
          fmt::format("{} is not a number of corners from 3 to 10000", as_written(numbers[0])));
    return regular_polygon(static_cast<long>(numerator(numbers[0])), numbers[1]);
  });
}

Profile read_profile(std::string_view bytes, const ProfileTolerance& tolerance) {
  if (const auto subpaths = svg_subpaths(bytes)) return outline_of(*subpaths, tolerance);
  const TextTable table(bytes, {true, "x, y"});
  if (table.columns() != 2)
    throw InputError(table.place(0),
                     fmt::format("a row has x, y, not {} columns", table.columns()));
  std::vector<std::vector<ProfilePoint>> rings(1);
  for (std::size_t k = 0; k < table.rows(); ++k) {
    if (table.is_after_gap(k)) rings.emplace_back();
    ProfilePoint corner;
    for (std::size_t axis = 0; axis < 2; ++axis) try {
        corner[axis] = table.number(k, axis);
      } catch (const InputError& error) {
        throw InputError(table.place(k), error.reason());
      }
    rings.back().push_back(corner);
  }
  return made([&] { return Profile::of_rings(std::move(rings)); });
}

std::optional<ProfileCurve> parse_profile_curve(std::string_view text) {
  const auto polygon = parse_profile(text);
  if (!polygon) return std::nullopt;
  const std::size_t colon = text.find(':');
  if (text.substr(0, colon) == "circle")
    return circle_curve(parse_short_number(text.substr(colon + 1)));
  return polygon_curve(*polygon);
}

ProfileCurve read_profile_curve(std::string_view bytes) {
  const Profile polygon = read_profile(bytes);
  if (const auto subpaths = svg_subpaths(bytes)) return outline_curve_of(*subpaths);
  return polygon_curve(polygon);
}

}  // namespace phrame
