#include "phrame/answer/offset_drawing.hpp"

#include <algorithm>

namespace phrame::inline v0 {

OffsetDrawing drawing(const OffsetAnswer& answer) {
  std::vector<Path> all;
  std::vector<Rational> sizes;
  for (const auto& part : answer.offsets) {
    sizes.push_back(abs(part.distance));
    all.insert(all.end(), part.paths.begin(), part.paths.end());
  }
  for (const auto& part : answer.trimmed) {
    sizes.push_back(abs(part.distance));
    for (const auto& branch : part.branches)
      all.insert(all.end(), branch.paths.begin(), branch.paths.end());
  }
  OffsetDrawing drawing{answer.path.name, {}, *std::ranges::min_element(sizes) * power_of_ten(-6)};
  for (const Path& path : all)
    drawing.paths.push_back({plane_cubics(path, drawing.tolerance), path.ends_meet()});
  return drawing;
}

}  // namespace phrame
