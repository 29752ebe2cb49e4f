#include "phrame/ph/sweep/profile.hpp"

#include <cmath>

#include <doctest/doctest.h>

#include "phrame/algebra/error.hpp"
#include "phrame/algebra/rounding.hpp"
#include "support/refusal.hpp"
#include "support/text.hpp"

using namespace phrame;

namespace {

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

std::string ring_complaint(const std::vector<std::vector<ProfilePoint>>& rings) {
  return test::refusal_of<DomainError>([&] { Profile::of_rings(rings); });
}

std::string complaint(const std::vector<ProfilePoint>& corners) {
  return test::refusal_of<DomainError>([&] { const Profile profile(corners); });
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
}

TEST_CASE("profile: of several rings one goes around the others, which are holes") {
  const std::vector<ProfilePoint> hole{{1, 1}, {2, 1}, {2, 2}};
  const std::vector<ProfilePoint> around{{0, 0}, {0, 9}, {9, 9}, {9, 0}};
  const std::vector<ProfilePoint> other{{4, 4}, {5, 7}, {6, 4}, {5, 5}};
  const Profile profile = Profile::of_rings({hole, around, other}, Rational(1, 3), Rational(1, 5));
  CHECK(
      profile.corners() ==
      std::vector<ProfilePoint>{
          {9, 0}, {9, 9}, {0, 9}, {0, 0}, {2, 2}, {2, 1}, {1, 1}, {4, 4}, {5, 7}, {6, 4}, {5, 5}});
  CHECK(profile.rings() == std::vector<std::size_t>{0, 4, 7});
  CHECK(profile.next(3) == 0);
  CHECK(profile.next(4) == 5);
  CHECK(profile.next(6) == 4);
  CHECK(profile.next(10) == 7);
  CHECK(profile.error() == Rational(1, 3));
  CHECK(profile.angle() == Rational(1, 5));
  const Profile divided = subdivided(profile, {1, 1, 1, 2, 1, 1, 1, 1, 1, 1, 3});
  CHECK(divided.corners().size() == 14);
  CHECK(divided.rings() == std::vector<std::size_t>{0, 5, 8});
  CHECK(divided.corners()[4] == ProfilePoint{Rational(9, 2), 0});
  CHECK(divided.next(4) == 0);
  CHECK(divided.next(13) == 8);
}

TEST_CASE("profile: rings that bound no one body are refused by their numbers") {
  const std::vector<ProfilePoint> square{{0, 0}, {9, 0}, {9, 9}, {0, 9}};
  const auto moved = [](int x, int y) {
    return std::vector<ProfilePoint>{{x, y}, {x + 2, y}, {x, y + 2}};
  };
  CHECK(test::contains(ring_complaint({square, moved(8, 1)}), "the rings 1 and 2 meet"));
  // At one corner, too, and along a side.
  CHECK(test::contains(ring_complaint({square, moved(0, 1)}), "the rings 1 and 2 meet"));
  CHECK(
      test::contains(ring_complaint({square, moved(1, 1), moved(3, 1)}), "the rings 2 and 3 meet"));
  CHECK(test::contains(ring_complaint({moved(20, 0), square}), "would be two bodies"));
  CHECK(test::contains(ring_complaint({{{1, 1}, {8, 1}, {8, 8}, {1, 8}}, square, moved(3, 3)}),
                       "the ring 3 is within the ring 1, which is a hole"));
  CHECK(test::contains(ring_complaint({square, {{1, 1}, {2, 2}}}), "(of the ring 2)"));
  CHECK(test::contains(ring_complaint({square, {{1, 1}, {3, 3}, {3, 1}, {1, 3}}}),
                       "(of the ring 2)"));
  CHECK(ring_complaint({}) != "");
  CHECK(ring_complaint({moved(3, 3), moved(6, 2), square}) == "");
}
