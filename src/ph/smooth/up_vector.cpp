#include "phrame/ph/smooth/up_vector.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numeric>

#include "phrame/algebra/error.hpp"
#include "phrame/algebra/sturm.hpp"
#include "phrame/ph/curve/vector.hpp"

namespace phrame {
namespace {

Vector<Polynomial> as_constant(const Vector<Rational>& v) {
  return {Polynomial{v[0]}, Polynomial{v[1]}, Polynomial{v[2]}};
}

/// The coefficients of H, those of all segments one after the other.
std::vector<Vector<Rational>> direction_coefficients(const SmoothPath& path) {
  std::vector<Vector<Rational>> all;
  for (const SmoothSegment& segment : path.segments()) {
    const Vector<Polynomial>& H = std::get<RationalCurve>(segment).direction();
    const long degree = std::max({H[0].degree(), H[1].degree(), H[2].degree()});
    for (long k = 0; k <= degree; ++k)
      all.push_back({H[0].coefficient(k), H[1].coefficient(k), H[2].coefficient(k)});
  }
  return all;
}

bool is_zero(const Vector<Rational>& v) { return v == Vector<Rational>{}; }

/// The first of them that is not 0.
Vector<Rational> first_direction(const std::vector<Vector<Rational>>& directions) {
  return *std::find_if(directions.begin(), directions.end(),
                       [](const auto& v) { return !is_zero(v); });
}

/// The first direction × another, where that is not 0.
std::optional<Vector<Rational>> first_normal(const std::vector<Vector<Rational>>& directions) {
  const Vector<Rational> first = first_direction(directions);
  for (const Vector<Rational>& other : directions)
    if (const Vector<Rational> normal = cross(first, other); !is_zero(normal)) return normal;
  return std::nullopt;
}

Vector<Rational> primitive(const Vector<Rational>& v) {
  const Rational size = common_content({Polynomial{v[0]}, Polynomial{v[1]}, Polynomial{v[2]}});
  return Rational(1 / size) * v;
}

/// Unit tangents at some points, for a guess.
std::vector<Vector<double>> sampled_tangents(const SmoothPath& path) {
  constexpr long bits = 64;
  const std::size_t count = path.segments().size();
  const long steps = std::max(4L, 64 / static_cast<long>(count));
  const std::size_t stride = 1 + count / 1024;
  std::vector<Vector<double>> all;
  for (std::size_t k = 0; k < count; k += stride) {
    const Vector<Polynomial>& H = std::get<RationalCurve>(path.segments()[k]).direction();
    for (long j = 0; j <= steps; ++j) {
      const Vector<Rational> h = evaluate(H, Rational(j, steps));
      const RealBall size = sqrt(RealBall(dot(h, h), bits), bits);
      Vector<double> unit{};
      for (std::size_t axis = 0; axis < 3; ++axis)
        unit[axis] = approximate(divide(RealBall(h[axis], bits), size, bits));
      all.push_back(unit);
    }
  }
  return all;
}

/// Integer vectors in all directions, one of each pair of opposite ones, z first.
std::vector<Vector<long>> candidates() {
  std::vector<Vector<long>> all;
  for (long size = 1; size <= 3; ++size)
    for (long z = 0; z <= size; ++z)
      for (long y = -size; y <= size; ++y)
        for (long x = -size; x <= size; ++x) {
          const bool is_first = z > 0 || (z == 0 && (y > 0 || (y == 0 && x > 0)));
          const bool is_new =
              std::max({std::abs(x), std::abs(y), z}) == size && std::gcd(std::gcd(x, y), z) == 1;
          if (is_first && is_new) all.push_back({x, y, z});
        }
  return all;
}

/// sin² of the smallest angle to one of the tangents.
double least_sine(const Vector<long>& v, const std::vector<Vector<double>>& tangents) {
  const Vector<double> w{static_cast<double>(v[0]), static_cast<double>(v[1]),
                         static_cast<double>(v[2])};
  double least = 1;
  for (const Vector<double>& t : tangents) {
    const Vector<double> c = cross(w, t);
    least = std::min(least, dot(c, c) / dot(w, w));
  }
  return least;
}

std::string where(const Interval& at, std::size_t segment) {
  const Rational offset(static_cast<long>(segment));
  if (at.lower == at.upper) return "t = " + abbreviated(to_string(Rational(*at.lower + offset)));
  return fmt::format("t ≈ {:.9g}", static_cast<double>((*at.lower + *at.upper) / 2 + offset));
}

/// The first place on the path.
std::optional<std::string> first_along(const SmoothPath& path, const Vector<Rational>& v) {
  for (std::size_t k = 0; k < path.segments().size(); ++k) {
    const auto at =
        std::visit([&](const auto& curve) { return tangent_along(curve, v); }, path.segments()[k]);
    if (at) return where(*at, k);
  }
  return std::nullopt;
}

}  // namespace

std::optional<Interval> tangent_along(const RationalCurve& curve, const Vector<Rational>& v) {
  const Vector<Polynomial> product = cross(as_constant(v), curve.direction());
  const Polynomial common = gcd(gcd(product[0], product[1]), product[2]);
  if (common.is_zero()) return closed(0, 0);
  if (common.is_constant()) return std::nullopt;
  const auto zeros = located_real_roots(common, closed(0, 1));
  if (zeros.empty()) return std::nullopt;
  return zeros.front();
}

void require_up_vector(const SmoothPath& path, const Vector<Rational>& v) {
  if (is_zero(v)) throw DomainError("the up vector is 0");
  if (const auto at = first_along(path, v))
    throw DomainError(
        fmt::format("the up vector {} is along the tangent at {}", abbreviated(v), *at));
}

bool is_straight(const SmoothPath& path) { return !first_normal(direction_coefficients(path)); }

std::optional<Vector<Rational>> plane_normal(const SmoothPath& path) {
  const auto directions = direction_coefficients(path);
  const auto normal = first_normal(directions);
  if (!normal) return std::nullopt;
  for (const Vector<Rational>& direction : directions)
    if (dot(*normal, direction) != 0) return std::nullopt;
  return primitive(*normal);
}

Vector<Rational> up_vector(const SmoothPath& path) {
  if (const auto normal = plane_normal(path)) return *normal;
  const auto tangents = sampled_tangents(path);
  std::vector<std::pair<double, Vector<long>>> ordered;
  for (const Vector<long>& v : candidates()) ordered.emplace_back(-least_sine(v, tangents), v);
  std::stable_sort(ordered.begin(), ordered.end(),
                   [](const auto& a, const auto& b) { return a.first < b.first; });
  for (const auto& [size, v] : ordered) {
    const Vector<Rational> up{v[0], v[1], v[2]};
    if (!first_along(path, up)) return up;
  }
  throw Undecided(fmt::format(
      "each of {} up vectors that were tried is along the tangent somewhere: name another one",
      ordered.size()));
}

}  // namespace phrame
