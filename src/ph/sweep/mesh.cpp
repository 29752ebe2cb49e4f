#include "phrame/ph/sweep/mesh.hpp"

#include <algorithm>

namespace phrame {

bool is_watertight(const Mesh& mesh) {
  std::vector<std::uint64_t> sides;
  std::vector<std::uint64_t> opposite;
  const auto side = [](std::uint64_t from, std::uint64_t to) { return from << 32U | to; };
  for (const auto& triangle : mesh.triangles)
    for (std::size_t k = 0; k < 3; ++k) {
      const std::uint32_t from = triangle[k];
      const std::uint32_t to = triangle[(k + 1) % 3];
      if (from == to) return false;
      sides.push_back(side(from, to));
      opposite.push_back(side(to, from));
    }
  std::sort(sides.begin(), sides.end());
  std::sort(opposite.begin(), opposite.end());
  return sides == opposite && std::adjacent_find(sides.begin(), sides.end()) == sides.end();
}

long euler_characteristic(const Mesh& mesh) {
  // Each of the three sides of a triangle is that of two.
  return static_cast<long>(mesh.points.size()) - static_cast<long>(mesh.triangles.size() / 2);
}

double volume(const Mesh& mesh) {
  // Of pyramids over the triangles with their apex at the first point, which keeps them small.
  double sum = 0;
  for (const auto& [i, j, k] : mesh.triangles) {
    Vector<double> a{};
    Vector<double> b{};
    Vector<double> c{};
    for (std::size_t n = 0; n < 3; ++n) {
      a[n] = mesh.points[i][n] - mesh.points[0][n];
      b[n] = mesh.points[j][n] - mesh.points[0][n];
      c[n] = mesh.points[k][n] - mesh.points[0][n];
    }
    sum += a[0] * (b[1] * c[2] - b[2] * c[1]) + a[1] * (b[2] * c[0] - b[0] * c[2]) +
           a[2] * (b[0] * c[1] - b[1] * c[0]);
  }
  return sum / 6;
}

}  // namespace phrame
