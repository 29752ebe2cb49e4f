#include "phrame/ph/sweep/profile_curve.hpp"

#include <doctest/doctest.h>
#include "phrame/algebra/error.hpp"
#include "phrame/algebra/rounding.hpp"

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
  const ProfileCurve back(reversed(line_and_arc()));
  CHECK(back.area().exact() == Rational(1, 3));
  CHECK(back.pieces() == given.pieces());
  CHECK(polygon_curve(rectangle_profile(2, 3)).area().exact() == Rational(6));
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
