#include "phrame/ph/sweep/mesh_numbers.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

#include "phrame/algebra/error.hpp"
#include "phrame/algebra/nearest_float.hpp"
#include "phrame/algebra/rounding.hpp"
#include "phrame/ph/curve/local_origin.hpp"
#include "phrame/ph/frame/frame.hpp"

namespace phrame::inline v0 {
namespace {

const char* name_of(Coordinates numbers) {
  return numbers == Coordinates::floats ? "floats" : "doubles";
}

/// Two points with the same coordinates.
std::optional<std::pair<std::size_t, std::size_t>> first_coincidence(
    const std::vector<Vector<double>>& points) {
  std::vector<std::size_t> order(points.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::sort(order.begin(), order.end(),
            [&](std::size_t a, std::size_t b) { return points[a] < points[b]; });
  const auto same =
      std::adjacent_find(order.begin(), order.end(),
                         [&](std::size_t a, std::size_t b) { return points[a] == points[b]; });
  if (same == order.end()) return std::nullopt;
  return std::minmax(*same, *(same + 1));
}

}  // namespace

MeshInFloats in_floats(const Mesh& mesh, const Vector<Rational>& origin) {
  MeshInFloats found{mesh, 0};
  found.mesh.origin = origin;
  Vector<double> shift{};
  double off = 0;  // of the shift
  for (std::size_t k = 0; k < 3; ++k) {
    const Rational exact = mesh.origin[k] - origin[k];
    shift[k] = round_to_double(exact);
    off += std::abs(round_to_double(exact - exact_rational(shift[k])));
  }
  for (Vector<double>& point : found.mesh.points) {
    Vector<double> error{};
    for (std::size_t k = 0; k < 3; ++k) {
      // The sum and what it is off, exactly [Knuth, TAOCP 4.2.2, theorem B].
      const double sum = point[k] + shift[k];
      const double part = sum - point[k];
      const double rest = (point[k] - (sum - part)) + (shift[k] - part);
      point[k] = static_cast<double>(as_float(sum));
      error[k] = std::abs(point[k] - sum) + std::abs(rest);
    }
    found.error = std::max(found.error, std::hypot(error[0], error[1], error[2]));
  }
  found.error = (found.error + off) * (1 + 0x1p-40);
  return found;
}

Vector<Rational> node_origin(const Mesh& mesh) {
  Vector<double> origin = round_to_double(mesh.origin);
  if (origin == Vector<double>{}) origin = local_origin(mesh.points);
  return {exact_rational(origin[0]), exact_rational(origin[1]), exact_rational(origin[2])};
}

double greatest_coordinate(Coordinates numbers) {
  return numbers == Coordinates::floats ? static_cast<double>(std::numeric_limits<float>::max())
                                        : std::numeric_limits<double>::max();
}

void require_apart(const Mesh& mesh, Coordinates numbers) {
  const double most = greatest_coordinate(numbers);
  for (const Vector<double>& point : mesh.points)
    for (const double x : point)
      if (!(std::abs(x) < most))
        fail_for_numbers(fmt::format("a coordinate is beyond {:.2g}, the greatest in {}", most,
                                     name_of(numbers)),
                         numbers);
  if (const auto same = first_coincidence(mesh.points))
    fail_for_numbers(fmt::format("the points {} and {} are the same in {}", same->first + 1,
                                 same->second + 1, name_of(numbers)),
                     numbers);
  if (const auto flat = first_flat_triangle(mesh))
    fail_for_numbers(fmt::format("the triangle {} has no area in {}", *flat + 1, name_of(numbers)),
                     numbers);
}

void fail_for_numbers(const std::string& what, Coordinates numbers) {
  throw Undecided("sweep: " + what +
                  (numbers == Coordinates::floats
                       ? "; PLY and OBJ have doubles, and an origin near the body (--origin auto) "
                         "leaves small numbers"
                       : "; an origin near the body (--origin auto) leaves small numbers"));
}

}  // namespace phrame
