#include "phrame/ph/curve/curve_point.hpp"

#include "phrame/ph/curve/curve_integrands.hpp"
#include "support/expression_curves.hpp"
#include "support/random.hpp"

using namespace phrame;
using test::expression_curve;

namespace {

std::vector<CurveIntegrand> integrands_of_all_kinds() {
  const RationalFunction speed(Polynomial{3, 1}, Polynomial{1, 0, 1});
  return {length_rate(),
          curvature_rate(),
          negative(torsion_rate()),
          bending_rate(),
          squared_torsion_rate(),
          up_frame_rate({1, 2, 3}),
          time_by_parameter(speed, 2),
          negative(time_by_curvature(speed, {1, -2, 2}))};
}

}  // namespace

TEST_CASE("curve point: law: an integrand there is the first coefficient of its series around it") {
  const ExpressionCurve c =
      expression_curve({"exp(s)*cos(3*s)", "s^2 + s", "sin(s) - s^3"}, "1", "2");
  test::for_samples(10, [&c](test::Random& random) {
    const Rational t(random.integer(0, 1000), 1000);
    const Rational half(random.integer(1, 9), 7);
    const CurvePoint point(c, RealBall(t, 150), half, 120);
    const CurveJet jet(c, RealBall(t, 150), half, 3, 120);
    for (const CurveIntegrand& y : integrands_of_all_kinds()) {
      const RealBall value = y(point);
      CHECK(value.accuracy_bits() > 80);
      CHECK(value.overlaps(series(y(jet)).coefficient(0)));
    }
  });
}

TEST_CASE("curve point: law: the integrands on a ball are around those at its points") {
  const ExpressionCurve c = expression_curve({"3*cos(s)", "sin(2*s)", "atan(s)"}, "0", "5");
  test::for_samples(10, [&c](test::Random& random) {
    const Rational t(random.integer(1, 999), 1000);
    const Rational radius(1, 1L << random.integer(10, 40));
    const CurvePoint on_ball(c, hull(t - radius, t + radius, 100), 1, 100);
    const CurvePoint at(c, RealBall(t + radius / 2, 100), 1, 100);
    for (const CurveIntegrand& y : integrands_of_all_kinds()) CHECK(y(on_ball).overlaps(y(at)));
  });
}
