#include "phrame/answer/offset_drawing.hpp"

#include <algorithm>

namespace phrame::inline v0 {
namespace {

OffsetDrawing drawing_of(const std::string& question, const std::string& name,
                         const std::vector<Path>& paths, const Rational& tolerance) {
  OffsetDrawing drawing{question, name, {}, tolerance};
  for (const Path& path : paths)
    drawing.paths.push_back({plane_cubics(path, drawing.tolerance), path.ends_meet()});
  return drawing;
}

OffsetNurbs nurbs_of(const std::string& question, const std::string& name,
                     const std::vector<Path>& paths) {
  OffsetNurbs nurbs{question, name, {}};
  for (const Path& path : paths) nurbs.parts.push_back({as_bspline(path), path.ends_meet()});
  return nurbs;
}

}  // namespace

Rational drawing_tolerance(const OffsetAnswer& answer) {
  std::vector<Rational> sizes;
  for (const auto& part : answer.offsets) sizes.push_back(abs(part.distance));
  for (const auto& part : answer.trimmed) sizes.push_back(abs(part.distance));
  for (const auto& part : answer.both) sizes.push_back(abs(part.distance));
  return *std::ranges::min_element(sizes) * power_of_ten(-6);
}

OffsetDrawing drawing(const OffsetAnswer& answer) {
  return drawing_of("offset", answer.path.name, all_paths(answer), drawing_tolerance(answer));
}

OffsetDrawing drawing(const EnvelopeAnswer& answer) {
  return drawing_of("envelope", answer.name, all_paths(answer),
                    answer.greatest_radius * power_of_ten(-6));
}

OffsetNurbs nurbs(const OffsetAnswer& answer) {
  return nurbs_of("offset", answer.path.name, all_paths(answer));
}

OffsetNurbs nurbs(const EnvelopeAnswer& answer) {
  return nurbs_of("envelope", answer.name, all_paths(answer));
}

}  // namespace phrame
