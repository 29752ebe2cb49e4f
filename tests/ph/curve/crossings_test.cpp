#include "phrame/ph/curve/crossings.hpp"

#include <cmath>

#include "phrame/ph/curve/vector.hpp"
#include "support/expression_curves.hpp"

using namespace phrame;
using test::expression_curve;
using test::torus_knot;

TEST_CASE("crossings: seen from above, a torus knot has its least number of them") {
  for (const auto& turns : {std::pair(2L, 3L), {2L, 5L}, {3L, 4L}, {3L, 7L}}) {
    const long p = turns.first;
    const long q = turns.second;
    CAPTURE(p);
    CAPTURE(q);
    const auto found = self_crossings(series_of(Path(torus_knot(p, q))), {0, 0, 1});
    REQUIRE(found);
    CHECK(found->size() == static_cast<std::size_t>(q * (p - 1)));
    CHECK(sum_of_signs(*found) == -q * (p - 1));
  }
}

TEST_CASE(
    "crossings: law: each is one, r(first) - r(second) along v, with the sign of the triple "
    "product") {
  const Vector<Rational> v{1, 2, 5};
  const ExpressionCurve c = torus_knot(3, 4);
  const auto found = self_crossings(series_of(Path(c)), v);
  REQUIRE(found);
  CHECK(found->size() >= 8);  // of the knot
  for (const Crossing& crossing : *found) {
    const auto p = c.series(crossing.first_t, 1, 2, 64);
    const auto q = c.series(crossing.second_t, 1, 2, 64);
    Vector<double> gap{};
    Vector<double> a{};
    Vector<double> b{};
    for (std::size_t k = 0; k < 3; ++k) {
      gap[k] = approximate(p[k].coefficient(0)) - approximate(q[k].coefficient(0));
      a[k] = approximate(p[k].coefficient(1));
      b[k] = approximate(q[k].coefficient(1));
    }
    CHECK(std::abs(gap[1] - 2 * gap[0]) < 1e-9);
    CHECK(std::abs(gap[2] - 5 * gap[0]) < 1e-9);
    CHECK(dot(cross(a, b), gap) * crossing.sign > 0);
  }
}

TEST_CASE(
    "crossings: a convex curve has none, and none are decided where the curve touches itself") {
  const Vector<Rational> up{0, 0, 1};
  const auto none = self_crossings(
      series_of(Path(expression_curve({"3*cos(s)", "sin(s)", "s*0"}, "0", "2*pi"))), up);
  REQUIRE(none);
  CHECK(none->empty());
  // A lemniscate that meets itself at 0, and two circles that touch, seen from above.
  CHECK_FALSE(self_crossings(
      series_of(Path(expression_curve({"sin(2*s)", "sin(s)", "0"}, "1", "1 + 2*pi"))), up));
  const CurveSeries circle =
      series_of(Path(expression_curve({"cos(s)", "sin(s)", "0"}, "1", "1 + 2*pi")));
  CHECK_FALSE(mutual_crossings(
      circle, series_of(Path(expression_curve({"2 + cos(s)", "sin(s)", "1"}, "1", "1 + 2*pi"))),
      up));
  CHECK(
      mutual_crossings(
          circle, series_of(Path(expression_curve({"1 + cos(s)", "sin(s)", "1"}, "0", "2*pi"))), up)
          ->size() == 2);
}

TEST_CASE("crossings: a plane curve that turns back at a joint, and meets itself further on") {
  // y = -x^2 up to 0, and back along y = -x^2/2 - 10/3 x^3: again for x = 3/20.
  const Polynomial x{Rational(1, 2), Rational(-1, 2)};
  const Polynomial z{0, Rational(1, 2)};
  const RationalCurve there({x, -(x * x), {}});
  const RationalCurve back({z, Rational(-1, 2) * z * z - Rational(10, 3) * z * z * z, {}});
  const auto found = self_intersections(plane_series({there.turned_over(), back}, {1, no_segment}));
  CHECK(found.is_complete());
  REQUIRE(found.found.size() == 1);
  CHECK(found.found[0].first_t.contains(Rational(7, 10)));
  CHECK(found.found[0].second_t.contains(Rational(3, 10)));
  CHECK(found.found[0].sign == 1);
}

TEST_CASE("crossings: a plane curve with a cusp between two inflections meets itself") {
  // (s^2, s^3(s^2 - 4/25)), -1/2 < s < 1/2: y = 0 again for s = -2/5 and 2/5.
  const Polynomial s{Rational(-1, 2), 1};
  const Polynomial y = s * s * s * (s * s - Polynomial{Rational(4, 25)});
  const auto found =
      self_intersections(plane_series({RationalCurve({s * s, y, {}})}, {no_segment}));
  CHECK(found.is_complete());
  REQUIRE(found.found.size() == 1);
  CHECK(found.found[0].first_t.contains(Rational(1, 10)));
  CHECK(found.found[0].second_t.contains(Rational(9, 10)));
}

TEST_CASE("crossings: of plane curves nothing is looked for at a gap, and ends may be anywhere") {
  const auto line = [](const Rational& x, const Rational& y, const Rational& dx,
                       const Rational& dy) {
    return RationalCurve({Polynomial{x, dx}, Polynomial{y, dy}, {}});
  };
  // Two lines that cross, each 2 long, and a third apart from them.
  const auto found = self_intersections(
      plane_series({line(0, 0, 2, 0), line(1, Rational(-3, 2), 0, 2), line(5, 5, 1, 1)},
                   {no_segment, no_segment, no_segment}));
  CHECK(found.is_complete());
  REQUIRE(found.found.size() == 1);
  CHECK(found.found[0].first_t.contains(Rational(1, 2)));
  CHECK(found.found[0].second_t.contains(Rational(3, 4)));
}
