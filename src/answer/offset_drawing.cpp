#include "phrame/answer/offset_drawing.hpp"

#include <algorithm>

namespace phrame::inline v0 {

OffsetDrawing drawing(const OffsetAnswer& answer) {
  std::vector<Rational> sizes;
  for (const auto& part : answer.offsets) sizes.push_back(abs(part.distance));
  for (const auto& part : answer.trimmed) sizes.push_back(abs(part.distance));
  OffsetDrawing drawing{answer.path.name, {}, *std::ranges::min_element(sizes) * power_of_ten(-6)};
  for (const Path& path : all_paths(answer))
    drawing.paths.push_back({plane_cubics(path, drawing.tolerance), path.ends_meet()});
  return drawing;
}

OffsetNurbs nurbs(const OffsetAnswer& answer) {
  OffsetNurbs nurbs{answer.path.name, {}};
  for (const Path& path : all_paths(answer))
    nurbs.parts.push_back({as_bspline(path), path.ends_meet()});
  return nurbs;
}

}  // namespace phrame
