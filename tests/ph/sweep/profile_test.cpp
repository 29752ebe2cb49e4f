#include "phrame/ph/sweep/profile.hpp"

#include <cmath>
#include <set>

#include "phrame/algebra/error.hpp"
#include "phrame/algebra/rounding.hpp"
#include "support/random.hpp"
#include "support/text.hpp"

using namespace phrame;
using test::for_samples;
using test::Random;

namespace {

Rational doubled_area(const ProfilePoint& a, const ProfilePoint& b, const ProfilePoint& c) {
  return (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]);
}

/// Of the polygon, by the trapezoids below its sides.
Rational doubled_area(const Profile& profile) {
  const auto& corners = profile.corners();
  Rational sum;
  for (std::size_t k = 0; k < corners.size(); ++k) {
    const auto& a = corners[k];
    const auto& b = corners[(k + 1) % corners.size()];
    sum += (a[0] - b[0]) * (a[1] + b[1]);
  }
  return sum;
}

/// Positive triangles that add up to the polygon and whose sides are those of the polygon, and each
/// other one twice: then they fill it.
void check_triangles(const Profile& profile) {
  const auto triangles = triangulated(profile);
  const auto n = static_cast<std::uint32_t>(profile.corners().size());
  CHECK(triangles.size() == n - 2);
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
    CHECK(sides.count({to, from}) == (to == (from + 1) % n ? 0 : 1));
  }
}

std::string complaint(const std::vector<ProfilePoint>& corners) {
  try {
    const Profile profile(corners);
  } catch (const DomainError& error) {
    return error.what();
  }
  return "";
}

}  // namespace

TEST_CASE("profile: a polygon is counterclockwise, whichever way it is given") {
  const Profile right({{0, 0}, {0, 1}, {1, 1}, {1, 0}});
  CHECK(doubled_area(right) == 2);
  CHECK(doubled_area(Profile({{0, 0}, {1, 0}, {0, 1}, {0, 0}})) == 1);
  CHECK(Profile({{0, 0}, {1, 0}, {0, 1}, {0, 0}}).corners().size() == 3);
  CHECK(right.reach() == doctest::Approx(std::sqrt(2)));
}

TEST_CASE("profile: what is no simple polygon is refused, with the corners") {
  CHECK(test::contains(complaint({{0, 0}, {1, 0}}), "2 corners"));
  CHECK(
      test::contains(complaint({{0, 0}, {1, 0}, {1, 0}, {0, 1}}), "corners 2 and 3 are the same"));
  CHECK(test::contains(complaint({{0, 0}, {1, 1}, {1, 0}, {0, 1}}), "corners 1 and 3 meet"));
  CHECK(test::contains(complaint({{0, 0}, {2, 0}, {1, 0}}), "turns back at the corner"));
  // It touches itself in a corner, and along a side.
  CHECK(test::contains(complaint({{0, 0}, {2, 0}, {2, 2}, {1, 0}, {0, 2}}), "meet"));
  CHECK(test::contains(complaint({{0, 0}, {4, 0}, {4, 1}, {3, 0}, {1, 0}, {0, 1}}), "meet"));
  CHECK_THROWS_AS(circle_profile(0, 1), DomainError);
  CHECK_THROWS_AS(circle_profile(1, power_of_ten(-9)), DomainError);
  CHECK_THROWS_AS(rectangle_profile(1, -1), DomainError);
  CHECK_THROWS_AS(regular_polygon(2, 1), DomainError);
}

TEST_CASE("profile: a circle is met within the tolerance, by not many more corners than needed") {
  for (const Rational& tolerance : {Rational(1, 10), Rational(1, 1000), Rational(1, 100'000)}) {
    const Profile circle = circle_profile(3, tolerance);
    const auto n = static_cast<double>(circle.corners().size());
    const double sagitta = 3 * (1 - std::cos(M_PI / n));
    CHECK(sagitta <= round_to_double(circle.error()));
    CHECK(circle.error() <= tolerance + power_of_two(-40));
    CHECK(3 * (1 - std::cos(M_PI / (0.9 * n))) > 0.9 * round_to_double(tolerance));
    for (const auto& [x, y] : circle.corners())
      CHECK(std::abs(std::hypot(round_to_double(x), round_to_double(y)) - 3) < 0x1p-48);
  }
}

TEST_CASE("profile: sides are divided evenly") {
  const Profile triangle({{0, 0}, {3, 0}, {0, 2}}, Rational(1, 9), Rational(1, 7));
  const Profile divided = subdivided(triangle, {3, 1, 2});
  CHECK(divided.corners() ==
        std::vector<ProfilePoint>{{0, 0}, {1, 0}, {2, 0}, {3, 0}, {0, 2}, {0, 1}});
  CHECK(divided.error() == Rational(1, 9));
  CHECK(divided.angle() == Rational(1, 7));
  CHECK(divided.next(5) == 0);
  check_triangles(divided);
}

TEST_CASE("profile: ears are clipped of convex, reflex and straight corners") {
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
TEST_CASE("profile: law: the triangles of any simple polygon fill it") {
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
