#include "phrame/ph/curve/gap.hpp"

#include <algorithm>

#include "phrame/algebra/rounding.hpp"
#include "phrame/ph/curve/vector.hpp"

namespace phrame::inline v0 {

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

bool is_small_beside(const Vector<Rational>& way, const std::vector<Vector<Rational>>& places) {
  const Rational squared = 32 * 32 * dot(way, way);
  return std::any_of(places.begin(), places.end(), [&](const Vector<Rational>& place) {
    const Vector<Rational> from_first = place - places.front();
    return dot(from_first, from_first) > squared;
  });
}

bool close_to_rounding(std::vector<Vector<Rational>>& points) {
  if (points.size() < 3 || points.front() == points.back() ||
      !are_within(rounding_gap(points), points.front(), points.back()) ||
      !is_small_beside(points.back() - points.front(), points))
    return false;
  points.back() = points.front();
  return true;
}

}  // namespace phrame
