#include "phrame/ph/sweep/profile_triangles.hpp"

#include <algorithm>
#include <cmath>
#include <set>

#include "phrame/algebra/error.hpp"
#include "phrame/algebra/rounding.hpp"
#include "support/random.hpp"

#include <doctest/doctest.h>

using namespace phrame;
using test::for_samples;
using test::Random;

namespace profile_triangles_test {

using Corners = std::vector<ProfilePoint>;

Rational doubled_area(const ProfilePoint& a, const ProfilePoint& b, const ProfilePoint& c) {
  return (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]);
}

/// Of the profile, by the trapezoids below its sides.
Rational doubled_area(const Profile& profile) {
  const auto& corners = profile.corners();
  Rational sum;
  for (std::size_t k = 0; k < corners.size(); ++k) {
    const auto& a = corners[k];
    const auto& b = corners[profile.next(k)];
    sum += (a[0] - b[0]) * (a[1] + b[1]);
  }
  return sum;
}

/// Positive triangles that add up to the polygon and whose sides are those of the polygon, and each
/// other one twice: then they fill it.
void check_triangles(const Profile& profile) {
  const auto triangles = triangulated(profile);
  CHECK(triangles.size() == profile.corners().size() + 2 * profile.rings().size() - 4);
  Rational sum;
  std::multiset<std::pair<std::uint32_t, std::uint32_t>> sides;
  for (const auto& [i, j, k] : triangles) {
    const Rational area =
        doubled_area(profile.corners()[i], profile.corners()[j], profile.corners()[k]);
    CHECK(area > 0);
    sum += area;
    sides.insert({{i, j}, {j, k}, {k, i}});
  }
  CHECK(sum == doubled_area(profile));
  for (const auto& [from, to] : sides) {
    CHECK(sides.count({from, to}) == 1);
    CHECK(sides.count({to, from}) == (to == profile.next(from) ? 0 : 1));
  }
}

TEST_CASE("triangles: ears are clipped of convex, reflex and straight corners") {
  check_triangles(regular_polygon(17, 2));
  check_triangles(rectangle_profile(2, Rational(1, 3)));
  check_triangles(Profile({{0, 0}, {4, 0}, {4, 4}, {2, 1}, {0, 4}}));
  // A comb, and a square with straight corners.
  check_triangles(
      Profile({{0, 0}, {6, 0}, {6, 5}, {5, 1}, {4, 5}, {3, 1}, {2, 5}, {1, 1}, {0, 5}}));
  check_triangles(Profile({{0, 0}, {1, 0}, {2, 0}, {2, 1}, {2, 2}, {1, 2}, {0, 2}, {0, 1}}));
  check_triangles(Profile({{0, 0}, {1, 0}, {2, 0}, {0, 2}}));
}

// Star-shaped polygons: the radii are random, the directions ascend, so that they are simple.
TEST_CASE("triangles: law: the triangles of any simple polygon fill it") {
  for_samples(40, [](Random& random) {
    std::vector<ProfilePoint> corners;
    const long n = random.integer(3, 40);
    for (long k = 0; k < n; ++k) {
      const double angle = 2 * M_PI * (static_cast<double>(k) + 0.1) / static_cast<double>(n);
      const Rational radius(random.integer(1, 12), random.integer(1, 3));
      corners.push_back(
          {radius * exact_rational(std::cos(angle)), radius * exact_rational(std::sin(angle))});
    }
    check_triangles(Profile(corners));
  });
}

// Doubles do not tell on which side of the line y = 3x/7 these corners are.
TEST_CASE("triangles: corners that are nearly on one line are told apart") {
  Corners corners{{2, Rational(6, 7)}, {0, 9}, {-1, Rational(-3, 7)}};
  for (long k = -9; k < 20; ++k) {
    const Rational x(k, 11);
    corners.push_back({x, x * Rational(3, 7) + (k % 3 == 0 ? 1 : -1) * power_of_two(-80 - k % 2)});
  }
  check_triangles(Profile(corners));
  check_triangles(Profile::of_rings({{{-9, -9}, {9, -9}, {9, 10}, {-9, 10}}, corners}));
}

TEST_CASE("triangles: holes stay open") {
  const Corners square{{0, 0}, {9, 0}, {9, 9}, {0, 9}};
  const auto box = [](int x, int y, int size) {
    return Corners{{x, y}, {x + size, y}, {x + size, y + size}, {x, y + size}};
  };
  check_triangles(Profile::of_rings({square, box(3, 3, 3)}));
  // In rows and columns, so that corners are on one line.
  std::vector<Corners> grid{square};
  for (const int x : {1, 3, 5, 7})
    for (const int y : {1, 3, 5, 7}) grid.push_back(box(x, y, 1));
  check_triangles(Profile::of_rings(grid));
  // The nearest corner is behind a hole that lies between.
  check_triangles(Profile::of_rings(
      {{{0, 0}, {20, 0}, {20, 9}, {0, 9}}, box(1, 4, 1), {{3, 1}, {4, 1}, {4, 8}, {3, 8}}}));
  // The third hole's nearest corner is (93, −30), behind the side by which the first was joined.
  check_triangles(Profile::of_rings({{{80, -60}, {300, -60}, {300, 200}, {-200, 200}, {-200, -60}},
                                     {{100, 0}, {90, 10}, {92, 2}},
                                     {{93, -30}, {96, -31}, {95, -34}},
                                     {{85, -30}, {80, -32}, {80, -28}}}));
  // A comb in a comb.
  check_triangles(Profile::of_rings(
      {{{0, 0}, {12, 0}, {12, 9}, {10, 3}, {8, 9}, {6, 3}, {4, 9}, {2, 3}, {0, 9}},
       {{1, 1}, {11, 1}, {11, 2}, {1, 2}}}));
}

// Stars in the squares of a board within a star: none meet.
TEST_CASE("triangles: law: those of any profile with holes fill it") {
  const auto star = [](Random& random, const ProfilePoint& center, const Rational& size) {
    Corners corners;
    const long n = random.integer(3, 12);
    for (long k = 0; k < n; ++k) {
      const double angle = 2 * M_PI * (static_cast<double>(k) + 0.1) / static_cast<double>(n);
      const Rational radius = size * Rational(random.integer(1, 4), 4);
      corners.push_back({center[0] + radius * exact_rational(std::round(8 * std::cos(angle)) / 8),
                         center[1] + radius * exact_rational(std::round(8 * std::sin(angle)) / 8)});
    }
    return corners;
  };
  for_samples(40, [&](Random& random) {
    std::vector<Corners> rings{{{-1, -1}, {40, 0}, {60, -20}, {41, 41}, {0, 40}}};
    const long count = random.integer(1, 4);
    for (long x = 0; x < count; ++x)
      for (long y = 0; y < count; ++y)
        if (random.integer(0, 3) > 0) rings.push_back(star(random, {10 * x + 5, 10 * y + 5}, 4));
    try {
      check_triangles(Profile::of_rings(rings));
    } catch (const DomainError&) {  // a star whose corners were rounded to one
    }
  });
}

}  // namespace profile_triangles_test
