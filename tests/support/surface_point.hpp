#pragma once
#include "phrame/ph/curve/vector.hpp"
#include "phrame/ph/sweep/rational_surface.hpp"

namespace phrame::inline v0::test {

using Homogeneous = Quaternion<Rational>;  ///< w and w·(x, y, z)

inline Homogeneous de_casteljau(std::vector<Homogeneous> points, const Rational& t) {
  const Rational left = 1 - t;
  for (std::size_t count = points.size() - 1; count > 0; --count)
    for (std::size_t k = 0; k < count; ++k) points[k] = left * points[k] + t * points[k + 1];
  return points.front();
}

/// S(u, s), by de Casteljau's algorithm.
inline Vector<Rational> point(const SurfacePatch& patch, const Rational& u, const Rational& s) {
  std::vector<Homogeneous> column;
  for (std::size_t k = 0; k < patch.points.size(); ++k) {
    std::vector<Homogeneous> row;
    for (std::size_t l = 0; l < patch.points[k].size(); ++l) {
      const Rational& weight = patch.weights[k][l];
      const auto& [x, y, z] = patch.points[k][l];
      row.push_back({weight, weight * x, weight * y, weight * z});
    }
    column.push_back(de_casteljau(std::move(row), u));
  }
  const auto [w, x, y, z] = de_casteljau(std::move(column), s);
  return {x / w, y / w, z / w};
}

}  // namespace phrame::test
