#include "phrame/answer/offset_drawing.hpp"

#include <algorithm>

namespace phrame::inline v0 {
namespace {

OffsetNurbs nurbs_of(const std::string& question, const std::string& name,
                     const std::vector<Path>& paths) {
  OffsetNurbs nurbs{question, name, {}};
  for (const Path& path : paths) nurbs.parts.push_back({as_bspline(path), path.ends_meet()});
  return nurbs;
}

}  // namespace

std::vector<OffsetCubics> cubics_of(const std::vector<Path>& paths, const Rational& tolerance) {
  std::vector<OffsetCubics> list;
  for (const Path& path : paths) list.push_back({plane_cubics(path, tolerance), path.ends_meet()});
  return list;
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
  const Rational tolerance = drawing_tolerance(answer);
  return {"offset", answer.path.name, cubics_of(all_paths(answer), tolerance), tolerance};
}

OffsetDrawing drawing(const EnvelopeAnswer& answer) {
  const Rational tolerance = drawing_tolerance(answer);
  return {"envelope", answer.name, cubics_of(all_paths(answer), tolerance), tolerance};
}

OffsetNurbs nurbs(const OffsetAnswer& answer) {
  return nurbs_of("offset", answer.path.name, all_paths(answer));
}

OffsetNurbs nurbs(const EnvelopeAnswer& answer) {
  return nurbs_of("envelope", answer.name, all_paths(answer));
}

}  // namespace phrame
