#include "phrame/answer/offset_drawing.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <optional>

#include "phrame/algebra/error.hpp"
#include "phrame/algebra/rounding.hpp"
#include "phrame/ph/curve/vector.hpp"

namespace phrame::inline v0 {
namespace {

OffsetNurbs nurbs_of(const std::string& question, const std::string& name,
                     const std::vector<Path>& paths) {
  OffsetNurbs nurbs{question, name, {}};
  for (const Path& path : paths) nurbs.parts.push_back({as_bspline(path), path.ends_meet()});
  return nurbs;
}

/// So many lines between points at equal steps of the parameter are within the tolerance of the
/// cubic: at n of them a line is at most |c″|/(8n²) from it, and |c″| is greatest at an end.
Integer lines_for(const PlaneCubic& cubic, const Rational& tolerance) {
  Rational most;  // of |c″|²/36
  for (const std::size_t k : {0UL, 1UL}) {
    Rational square;
    for (const std::size_t j : {0UL, 1UL}) {
      const Rational bend = cubic[k][j] - 2 * cubic[k + 1][j] + cubic[k + 2][j];
      square += bend * bend;
    }
    most = std::max(most, square);
  }
  return sqrt(sqrt(floor(Rational(36, 64) * most / (tolerance * tolerance)))) + 1;
}

std::array<Rational, 2> point_of(const PlaneCubic& cubic, const Rational& t) {
  PlaneCubic at = cubic;
  for (std::size_t left = 3; left > 0; --left)
    for (std::size_t k = 0; k < left; ++k)
      for (const std::size_t j : {0UL, 1UL}) at[k][j] += t * (at[k + 1][j] - at[k][j]);
  return at[0];
}

OffsetPolylines polylines_of(const std::string& question, const std::vector<Path>& paths,
                             const Rational& tolerance) {
  constexpr long most_lines = 1'000'000;
  // An eighth is for cubics, three quarters for lines between points of these; decimals move a
  // point by less than an eighth.
  const Rational small = tolerance / 8;
  OffsetPolylines found{question, {}, std::max(0L, -decimal_exponent(small)), tolerance};
  const std::vector<OffsetCubics> drawn = cubics_of(paths, small);
  Integer count;
  for (const OffsetCubics& path : drawn) {
    if (path.tolerance > small)
      throw InputError("tolerance",
                       upper_bound_text(tolerance) + " is less than 1e-8 of the size of a path");
    for (const PlaneCubic& cubic : path.cubics) count += lines_for(cubic, 6 * small);
  }
  if (count > most_lines)
    throw InputError("tolerance", fmt::format("{} asks for {} lines, the limit is {}",
                                              upper_bound_text(tolerance), abbreviated(count.str()),
                                              most_lines));
  const Rational unit = power_of_ten(found.places);
  for (const OffsetCubics& path : drawn) {
    auto& points = found.paths.emplace_back();
    const auto add = [&](const std::array<Rational, 2>& at) {
      const auto next = [&](const Rational& x) { return floor(x * unit + Rational(1, 2)); };
      const OffsetPolylines::Point rounded{next(at[0]), next(at[1])};
      if (points.empty() || points.back() != rounded) points.push_back(rounded);
    };
    add(path.cubics.front().front());
    for (const PlaneCubic& cubic : path.cubics) {
      const Integer lines = lines_for(cubic, 6 * small);
      for (Integer k = 1; k <= lines; ++k) add(point_of(cubic, Rational(k, lines)));
    }
  }
  return found;
}

/// How far ends and middles of its segments are from its start.
Rational size_of(const Path& path) {
  std::optional<Vector<Rational>> start;
  Rational most;
  for (const Segment& segment : path.segments())
    for (const Rational& t : {Rational(0), Rational(1, 2), Rational(1)}) {
      const Vector<Rational> at = point(*rational_curve(segment), t);
      if (!start) start = at;
      for (std::size_t k = 0; k < 2; ++k) most = std::max(most, abs(at[k] - (*start)[k]));
    }
  return most;
}

}  // namespace

std::vector<OffsetCubics> cubics_of(const std::vector<Path>& paths, const Rational& tolerance) {
  std::vector<OffsetCubics> list;
  for (const Path& path : paths) {
    const Rational size = size_of(path);
    const Rational seen = size == 0 ? tolerance : power_of_ten(decimal_exponent(size) - 9);
    const Rational within = std::max(tolerance, seen);
    list.push_back({plane_cubics(path, within), path.ends_meet(), within});
  }
  return list;
}

void ToleranceRange::add(const std::vector<OffsetCubics>& paths) {
  for (const OffsetCubics& path : paths) {
    least = greatest == 0 ? path.tolerance : std::min(least, path.tolerance);
    greatest = std::max(greatest, path.tolerance);
  }
}

Rational drawing_tolerance(const OffsetAnswer& answer) {
  std::vector<Rational> sizes;
  for (const auto& part : answer.offsets) sizes.push_back(abs(part.distance));
  for (const auto& part : answer.trimmed) sizes.push_back(abs(part.distance));
  for (const auto& part : answer.both) sizes.push_back(abs(part.distance));
  return *std::ranges::min_element(sizes) * power_of_ten(-6);
}

Rational drawing_tolerance(const EnvelopeAnswer& answer) {
  return answer.greatest_radius * power_of_ten(-6);
}

OffsetDrawing drawing(const OffsetAnswer& answer) {
  return {"offset", answer.path.name, cubics_of(all_paths(answer), drawing_tolerance(answer))};
}

OffsetDrawing drawing(const EnvelopeAnswer& answer) {
  return {"envelope", answer.name, cubics_of(all_paths(answer), drawing_tolerance(answer))};
}

OffsetPolylines polylines(const OffsetAnswer& answer, const std::optional<Rational>& tolerance) {
  return polylines_of("offset", all_paths(answer),
                      tolerance.value_or(1000 * drawing_tolerance(answer)));
}

OffsetPolylines polylines(const EnvelopeAnswer& answer, const std::optional<Rational>& tolerance) {
  return polylines_of("envelope", all_paths(answer),
                      tolerance.value_or(1000 * drawing_tolerance(answer)));
}

OffsetNurbs nurbs(const OffsetAnswer& answer) {
  return nurbs_of("offset", answer.path.name, all_paths(answer));
}

OffsetNurbs nurbs(const EnvelopeAnswer& answer) {
  return nurbs_of("envelope", answer.name, all_paths(answer));
}

}  // namespace phrame
