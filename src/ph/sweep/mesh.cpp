#include "phrame/ph/sweep/mesh.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "phrame/ph/curve/vector.hpp"
#include "phrame/ph/sweep/mesh_sides.hpp"

namespace phrame::inline v0 {

namespace {

/// Is a component of (b − a) × (c − a) surely not 0? The differences, products and their difference
/// are each off by 2^−53 of themselves, or by 2^−1074.
bool has_area_in_doubles(const Vector<double>& a, const Vector<double>& b,
                         const Vector<double>& c) {
  for (std::size_t k = 0; k < 3; ++k) {
    const std::size_t m = (k + 1) % 3;
    const double left = (b[k] - a[k]) * (c[m] - a[m]);
    const double right = (b[m] - a[m]) * (c[k] - a[k]);
    const double most = std::abs(left) + std::abs(right);
    if (most < HUGE_VAL && std::abs(left - right) > 0x1p-49 * most + 0x1p-1000) return true;
  }
  return false;
}

}  // namespace

bool has_area(const Vector<double>& a, const Vector<double>& b, const Vector<double>& c) {
  if (has_area_in_doubles(a, b, c)) return true;
  const auto exact = [](const Vector<double>& p) {
    return Vector<Rational>{exact_rational(p[0]), exact_rational(p[1]), exact_rational(p[2])};
  };
  return cross(exact(b) - exact(a), exact(c) - exact(a)) != Vector<Rational>{};
}

MeshSides::MeshSides(std::size_t points, std::span<const std::array<std::uint32_t, 3>> triangles,
                     std::span<const Side> others)
    : first_(points + 1), ends_(3 * triangles.size() + others.size()) {
  for (const auto& triangle : triangles)
    for (const std::uint32_t from : triangle) ++first_[from + 1];
  for (const auto& [from, to] : others) ++first_[from + 1];
  std::partial_sum(first_.begin(), first_.end(), first_.begin());
  std::vector<std::size_t> next(first_.begin(), first_.end() - 1);
  for (const auto& triangle : triangles)
    for (std::size_t k = 0; k < 3; ++k) ends_[next[triangle[k]]++] = triangle[(k + 1) % 3];
  for (const auto& [from, to] : others) ends_[next[from]++] = to;
  const auto at = [&](std::size_t k) { return ends_.begin() + static_cast<std::ptrdiff_t>(k); };
  for (std::size_t from = 0; from < points; ++from)
    std::sort(at(first_[from]), at(first_[from + 1]));
}

bool MeshSides::has(std::uint32_t from, std::uint32_t to) const {
  return std::binary_search(begin(from), end(from), to);
}

bool MeshSides::has_twice(std::uint32_t from) const {
  return std::adjacent_find(begin(from), end(from)) != end(from);
}

bool is_watertight(const Mesh& mesh) {
  return MeshSides(mesh.points.size(), mesh.triangles).are_paired();
}

std::optional<std::size_t> first_flat_triangle(const Mesh& mesh) {
  for (std::size_t n = 0; n < mesh.triangles.size(); ++n) {
    const auto& [i, j, k] = mesh.triangles[n];
    if (!has_area(mesh.points[i], mesh.points[j], mesh.points[k])) return n;
  }
  return std::nullopt;
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
