#include "phrame/io/write/step_body.hpp"

#include "phrame/algebra/rounding.hpp"

namespace phrame::inline v0 {

StepBody step_body(const RationalSweepAnswer& answer) {
  const RationalSurface& surface = answer.surface;
  StepBody body{{}, surface.sides, surface.rings, surface.is_closed};
  for (const SurfacePatch& patch : surface.patches) {
    StepPatch rounded;
    for (std::size_t k = 0; k < patch.points.size(); ++k) {
      auto& points = rounded.points.emplace_back();
      auto& weights = rounded.weights.emplace_back();
      for (std::size_t l = 0; l < patch.points[k].size(); ++l) {
        const auto& [x, y, z] = patch.points[k][l];
        points.push_back({round_to_double(x), round_to_double(y), round_to_double(z)});
        weights.push_back(round_to_double(patch.weights[k][l]));
      }
    }
    body.patches.push_back(std::move(rounded));
  }
  return body;
}

}  // namespace phrame
