#include "phrame/ph/sweep/profile_apart.hpp"

#include <doctest/doctest.h>

#include "phrame/algebra/error.hpp"

using namespace phrame;

namespace profile_apart_test {

using Ring = std::vector<PlaneBezier>;

Ring circle_around(const ProfilePoint& center, const Rational& radius) {
  Ring quarters = circle_curve(radius).pieces();
  for (PlaneBezier& quarter : quarters)
    for (ProfilePoint& point : quarter.points)
      for (std::size_t axis = 0; axis < 2; ++axis) point[axis] += center[axis];
  return quarters;
}

bool are_seen_apart(std::vector<Ring> rings) {
  try {
    require_rings_apart(ProfileCurve::of_rings(std::move(rings)));
  } catch (const Undecided&) {
    return false;
  }
  return true;
}

}  // namespace profile_apart_test

using namespace profile_apart_test;

// The circle around (3, 4) with the radius 5 touches that around 0 with the radius 10 at (6, 8).
TEST_CASE("profile apart: circles within a circle, by the distance of their centers") {
  const Ring around = circle_around({0, 0}, 10);
  const auto hole = [](const Rational& less) { return circle_around({3, 4}, Rational(5) - less); };
  CHECK(are_seen_apart({around}));
  CHECK(are_seen_apart({around, hole(1)}));
  CHECK(are_seen_apart({around, hole(Rational(1, 1000))}));
  CHECK_FALSE(are_seen_apart({around, hole(0)}));
  CHECK_FALSE(are_seen_apart({around, hole(Rational(-1, 1'000'000))}));
  for (const ProfilePoint& at : {ProfilePoint{-3, 4}, ProfilePoint{-3, -4}, ProfilePoint{4, -3}})
    CHECK_FALSE(are_seen_apart({around, circle_around(at, 5 + Rational(1, 1000))}));
  CHECK(are_seen_apart({around, circle_around({0, 0}, Rational(99, 10))}));
}

// Two holes that touch, or nearly so; a cubic that comes to y = 3/4 below a line.
TEST_CASE("profile apart: holes, and curves whose control points reach beyond") {
  const Ring around = circle_around({0, 0}, 10);
  const Ring left = circle_around({-2, 1}, 2);
  CHECK_FALSE(are_seen_apart({around, left, circle_around({2, 1}, 2)}));
  CHECK(are_seen_apart({around, left, circle_around({2, 1}, Rational(199, 100))}));
  const Ring arch{{{{0, 0}, {0, 1}, {1, 1}, {1, 0}}, {1, 1, 1, 1}}, {{{1, 0}, {0, 0}}, {1, 1}}};
  const auto bar = [](const Rational& y) {
    return polygon_curve(Profile({{0, y}, {1, y}, {1, 2}, {0, 2}})).pieces();
  };
  CHECK(are_seen_apart({around, arch, bar(Rational(751, 1000))}));
  CHECK_FALSE(are_seen_apart({around, arch, bar(Rational(3, 4))}));
  CHECK_THROWS_WITH_AS(
      require_rings_apart(ProfileCurve::of_rings({arch, around, bar(Rational(1, 2))})),
      "profile: whether the outlines 2 and 3 meet is not told: they touch, or nearly so",
      Undecided);
}
