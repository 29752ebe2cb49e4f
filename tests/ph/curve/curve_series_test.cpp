#include "phrame/ph/curve/curve_series.hpp"

#include "phrame/algebra/rounding.hpp"
#include "support/expression_curves.hpp"
#include "support/paths.hpp"
#include "support/random.hpp"

using namespace phrame;
using test::for_samples;
using test::Random;

TEST_CASE("curve series: law: of a rational curve its Taylor polynomials, and balls hold them") {
  for_samples(50, [](Random& random) {
    const Polynomial weight{random.integer(5, 9), random.integer(-1, 1), random.integer(-2, 2)};
    const Vector<Polynomial> x{random.polynomial(4), random.nonconstant_polynomial(4), {1, 2, 3}};
    const CurveSeries series = series_of(Path(RationalCurve(x, weight)));
    const Rational t(random.integer(0, 8), 8);
    const auto at = series.position(0, RealBall(t, 100), 3, 100);
    const auto wide = series.position(0, widened(RealBall(t, 100), 0.01), 3, 100);
    for (std::size_t k = 0; k < 3; ++k) {
      const RationalFunction r(x[k], weight);
      CHECK(at[k].coefficient(0).contains(x[k](t) / weight(t)));
      const RationalFunction slope = differentiate(r);
      CHECK(at[k].coefficient(1).contains(slope.numerator()(t) / slope.denominator()(t)));
      const Rational next = t + Rational(1, 100);
      CHECK(wide[k].coefficient(0).contains(x[k](next) / weight(next)));
    }
  });
}

TEST_CASE("curve series: of a PH path those of its segments") {
  const CurveSeries series = series_of(test::closed_loop());
  CHECK(series.segments == 4);
  const auto end = series.position(1, RealBall(1, 64), 1, 64);
  const auto start = series.position(2, RealBall(), 1, 64);
  for (std::size_t k = 0; k < 3; ++k)
    CHECK(end[k].coefficient(0).overlaps(start[k].coefficient(0)));
}

TEST_CASE("curve series: of formulas their series along t") {
  const CurveSeries series =
      series_of(Path(test::expression_curve({"s^2", "s", "1"}, "1", "3")));  // s = 1 + 2t
  const auto r = series.position(0, RealBall(Rational(1, 2), 64), 3, 64);
  CHECK(r[0].coefficient(0).contains(4));
  CHECK(r[0].coefficient(1).contains(8));
  CHECK(r[0].coefficient(2).contains(4));
}

TEST_CASE(
    "curve series: around a part of a rational curve they are as wide far from 0 as near it") {
  const auto widths = [](long x) {  // a quarter circle of radius 5
    const CurveSeries series =
        series_of(Path(bezier_curve({{x + 5, x, x}, {x + 5, x + 5, x}, {x, x + 5, x}}, {1, 1, 2})));
    const Vector<BallPolynomial> r =
        series.position(0, hull(Rational(1, 2), Rational(5, 8), 64), 3, 64);
    return Vector<double>{round_to_double(r[0].coefficient(0).radius()),
                          round_to_double(r[0].coefficient(1).radius()),
                          round_to_double(r[1].coefficient(2).radius())};
  };
  const Vector<double> near = widths(0);
  for (const long x : {1000L, -1000000L, 1000000000L})
    for (std::size_t k = 0; k < 3; ++k) CHECK(widths(x)[k] <= 1.01 * near[k]);
}
