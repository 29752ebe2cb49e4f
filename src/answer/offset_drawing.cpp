#include "phrame/answer/offset_drawing.hpp"

#include <algorithm>
#include <optional>

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

OffsetNurbs nurbs(const OffsetAnswer& answer) {
  return nurbs_of("offset", answer.path.name, all_paths(answer));
}

OffsetNurbs nurbs(const EnvelopeAnswer& answer) {
  return nurbs_of("envelope", answer.name, all_paths(answer));
}

}  // namespace phrame
