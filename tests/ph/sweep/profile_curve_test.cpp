#include "phrame/ph/sweep/profile_curve.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include "phrame/algebra/error.hpp"
#include "phrame/algebra/rounding.hpp"
#include "support/refusal.hpp"

using namespace phrame;

namespace profile_curve_test {

/// The point at u, by polynomials.
ProfilePoint at(const PlaneBezier& piece, const Rational& u) {
  const auto [x, y, weight] = polynomials(piece);
  return {x(u) / weight(u), y(u) / weight(u)};
}

/// (0, 0) → (1, 0) → a parabola back.
std::vector<PlaneBezier> line_and_arc() {
  return {{{{0, 0}, {1, 0}}, {1, 1}}, {{{1, 0}, {Rational(1, 2), 1}, {0, 0}}, {1, 1, 1}}};
}

bool is_refused(const std::vector<PlaneBezier>& pieces) {
  try {
    const ProfileCurve curve(pieces);
  } catch (const DomainError&) {
    return true;
  }
  return false;
}

/// A circle of radius 1 around (x, 0).
std::vector<PlaneBezier> circle_at(long x) {
  auto quarters = circle_curve(1).pieces();
  for (PlaneBezier& quarter : quarters)
    for (ProfilePoint& point : quarter.points) point[0] += x;
  return quarters;
}

}  // namespace profile_curve_test

using namespace profile_curve_test;

TEST_CASE("profile curve: all of a circle is at the radius, and its area is pi times its square") {
  const ProfileCurve circle = circle_curve(Rational(3, 2));
  CHECK(circle.pieces().size() == 4);
  for (const PlaneBezier& piece : circle.pieces())
    for (long k = 0; k <= 8; ++k) {
      const auto [x, y] = at(piece, Rational(k, 8));
      CHECK(x * x + y * y == Rational(9, 4));
    }
  CHECK(circle.pieces().front().points.front() == ProfilePoint{Rational(3, 2), 0});
  CHECK(round_to_double(circle.area()) == doctest::Approx(9 * M_PI / 4).epsilon(1e-15));
}

// Below y = 2x(1 − x), which the parabola is: the area is 2(1/2 − 1/3).
TEST_CASE("profile curve: it is counterclockwise, in whichever direction it is given") {
  const ProfileCurve given(line_and_arc());
  CHECK(given.area().exact() == Rational(1, 3));
  const ProfileCurve back(reversed_pieces(given));
  CHECK(back.area().exact() == Rational(1, 3));
  CHECK(back.pieces() == given.pieces());
  CHECK(polygon_curve(rectangle_profile(2, 3)).area().exact() == Rational(6));
}

// Within 10 × 4 two circles of the same area, one of them given clockwise, before what is around
// them. The area is 40 − 2π; ½∫(x dy − y dx) along the pieces is that only where the holes are
// clockwise.
TEST_CASE("profile curve: one ring goes around all the others, which are holes") {
  const ProfileCurve back(circle_at(3));
  const auto around = polygon_curve(rectangle_profile(10, 4)).pieces();
  const ProfileCurve given = ProfileCurve::of_rings({circle_at(-3), reversed_pieces(back), around});
  CHECK(given.rings() == std::vector<std::size_t>{0, 4, 8});
  CHECK(round_to_double(given.area()) == doctest::Approx(40 - 2 * M_PI).epsilon(1e-15));
  CHECK(std::equal(around.begin(), around.end(), given.pieces().begin()));
  CHECK(given.pieces()[4].points.front() == ProfilePoint{-2, 0});
  CHECK(given.pieces()[4].points.back() == ProfilePoint{-3, -1});
  CHECK(given.pieces()[8].points.front() == ProfilePoint{4, 0});
  CHECK(given.pieces()[8].points.back() == ProfilePoint{3, -1});
  const auto other_way = reversed_pieces(given);
  CHECK(other_way[0] == reversed(around[3]));
  CHECK(other_way[4] == circle_at(-3)[0]);
  CHECK(other_way[11] == circle_at(3)[3]);
}

TEST_CASE("profile curve: a polygon keeps its holes") {
  const Profile frame =
      Profile::of_rings({{{0, 0}, {3, 0}, {3, 3}, {0, 3}}, {{1, 1}, {2, 1}, {2, 2}}});
  const ProfileCurve curve = polygon_curve(frame);
  CHECK(curve.rings() == std::vector<std::size_t>{0, 4});
  CHECK(curve.area().exact() == Rational(17, 2));
  for (std::size_t k = 0; k < 7; ++k) {
    CHECK(curve.pieces()[k].points.front() == frame.corners()[k]);
    CHECK(curve.pieces()[k].points.back() == frame.corners()[frame.next(k)]);
  }
}

TEST_CASE("profile curve: rings that are no outline with holes are refused by number") {
  const auto refusal = [](std::vector<std::vector<PlaneBezier>> rings) -> std::string {
    return test::refusal_of<DomainError>([&] { ProfileCurve::of_rings(std::move(rings)); });
  };
  CHECK(refusal({}) == "profile: it has no ring");
  auto open = line_and_arc();
  open.back().points.back() = {0, 1};
  CHECK(refusal({circle_at(0), open}) ==
        "profile: the piece 1 does not begin where the piece 2 ends (of the ring 2)");
  CHECK(refusal({circle_at(0), polygon_curve(rectangle_profile(1, 2)).pieces(),
                 polygon_curve(rectangle_profile(2, 1)).pieces()}) ==
        "profile: the holes have not less area than the outline around them");
}

TEST_CASE("profile curve: what does not close, or has no area, is refused") {
  auto open = line_and_arc();
  open.back().points.back() = {0, 1};
  CHECK(is_refused(open));
  auto negative = line_and_arc();
  negative.back().weights[1] = -1;
  CHECK(is_refused(negative));
  CHECK(is_refused({{{{0, 0}, {1, 0}}, {1, 1}}, {{{1, 0}, {0, 0}}, {1, 1}}}));
  CHECK(is_refused({}));
  CHECK_THROWS_AS(circle_curve(0), DomainError);
}

// 1 − 3t + 3t² > 0, whose Bernstein coefficients are 1, −1/2, 1.
TEST_CASE("profile curve: a piece is halved until its weights are positive") {
  const PlaneRational curve{{0, 1}, {1}, {1, -3, 3}};
  const auto pieces = bezier_pieces(curve);
  CHECK(pieces.size() == 2);
  for (std::size_t k = 0; k < 2; ++k) {
    for (const Rational& weight : pieces[k].weights) CHECK(weight > 0);
    for (const Rational& u : {Rational(0), Rational(1, 3), Rational(1)}) {
      const Rational t = (Rational(static_cast<long>(k)) + u) / 2;
      CHECK(at(pieces[k], u) == ProfilePoint{t / curve.weight(t), 1 / curve.weight(t)});
    }
  }
}
