#include "phrame/ph/curve/gap.hpp"

#include <algorithm>

#include "phrame/algebra/rounding.hpp"
#include "phrame/ph/curve/vector.hpp"

namespace phrame {

Rational rounding_gap(const std::vector<Vector<Rational>>& places) {
  Rational greatest;
  for (const Vector<Rational>& place : places)
    for (const Rational& x : place) greatest = std::max(greatest, Rational(abs(x)));
  return greatest * power_of_two(-48);
}

bool are_within(const Rational& gap, const Vector<Rational>& a, const Vector<Rational>& b) {
  const Vector<Rational> way = b - a;
  return dot(way, way) <= gap * gap;
}

bool close_to_rounding(std::vector<Vector<Rational>>& points) {
  if (points.size() < 3 || points.front() == points.back() ||
      !are_within(rounding_gap(points), points.front(), points.back()))
    return false;
  const Vector<Rational> way = points.back() - points.front();
  const bool is_long = std::any_of(points.begin(), points.end(), [&](const auto& point) {
    const Vector<Rational> from_start = point - points.front();
    return dot(from_start, from_start) > 1024 * dot(way, way);
  });
  if (!is_long) return false;
  points.back() = points.front();
  return true;
}

}  // namespace phrame
