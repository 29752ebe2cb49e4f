#include "phrame/ph/curve/curve_integrands.hpp"

#include "phrame/algebra/ball_order.hpp"
#include "phrame/ph/along/expression_integral.hpp"
#include "support/expression_curves.hpp"
#include "support/random.hpp"

using namespace phrame;
using test::expression_curve;
using test::torus_knot;

namespace {

RealBall integral(const ExpressionCurve& c, const CurveIntegrand& rate, const Rational& t = 1) {
  REQUIRE_FALSE(taylor_parts(c, rate)->fault);
  return ExpressionIntegral(c, rate).enclose(t, 120);
}

bool is_near(const RealBall& value, const char* digits) {
  const RealBall difference = subtract(value, RealBall(parse_rational(digits), 200), 200);
  return is_less(absolute(difference),
                 RealBall(Rational(1, 10'000'000'000'000) * Rational(1, 10'000'000'000), 64));
}

}  // namespace

// The integrals below are sums of 400 and 600 values by mpmath with 28 digits, which agree: the
// trapezoidal rule converges geometrically for periodic functions.
TEST_CASE("curve integrands: a trefoil has the totals that mpmath finds") {
  const ExpressionCurve c = torus_knot(2, 3);
  CHECK(is_near(integral(c, length_rate()), "31.898600666412336249021989243"));
  CHECK(is_near(integral(c, torsion_rate()), "-15.593362799471348746817997768"));
  CHECK(is_near(integral(c, bending_rate()), "10.205541817457138073695257526"));
  CHECK(is_near(integral(c, squared_torsion_rate()), "26.696349245961080065313749794"));
  if (test::multiplier() == 1) return;  // the next one has these
  CHECK(is_near(integral(c, curvature_rate()), "17.822412418300797344840535859"));
  CHECK(is_near(integral(c, up_frame_rate({0, 0, 1})), "3.256193122067410683957862531"));
}

TEST_CASE("curve integrands: so has a Fourier trefoil, whose v-frame turns by 2.225…") {
  const ExpressionCurve c =
      expression_curve({"sin(s) + 2*sin(2*s)", "cos(s) - 2*cos(2*s)", "-sin(3*s)"}, "0", "2*pi");
  CHECK(is_near(integral(c, up_frame_rate({0, 0, 1})), "2.2250406424344893618089754546"));
  CHECK(is_near(integral(c, torsion_rate()), "2.2250406424344893618089754546"));
  CHECK(is_near(integral(c, curvature_rate()), "13.950320176952502231767302321"));
}

TEST_CASE("curve integrands: a helix has constant curvature and torsion") {
  // Radius 3, pitch 4: κ = 3/25, τ = 4/25, |r′| = 5.
  const ExpressionCurve c = expression_curve({"3*cos(s)", "3*sin(s)", "4*s"}, "0", "7");
  CHECK(integral(c, length_rate()).contains(35));
  CHECK(integral(c, curvature_rate()).contains(Rational(21, 5)));
  CHECK(integral(c, torsion_rate()).contains(Rational(28, 5)));
  CHECK(integral(c, torsion_rate(), Rational(3, 7)).contains(Rational(12, 5)));
  CHECK(integral(c, bending_rate()).contains(Rational(63, 125)));
  CHECK(integral(c, squared_torsion_rate()).contains(Rational(112, 125)));
  // Its axis makes a constant angle with the tangent: the frame of v is Frenet's, turned.
  CHECK(integral(c, up_frame_rate({0, 0, 1})).contains(Rational(28, 5)));
}

TEST_CASE("curve integrands: law: frames of two v differ by whole turns around a closed curve") {
  const ExpressionCurve c = torus_knot(3, 2);
  const RealBall a = integral(c, up_frame_rate({0, 0, 1}));
  const RealBall b = integral(c, up_frame_rate({2, 1, 3}));
  const RealBall turns = divide(subtract(a, b, 150), times_power_of_two(pi(150), 1), 150);
  CHECK(unique_integer(turns));
}

TEST_CASE("curve integrands: a reversed curve keeps what does not depend on its sense") {
  const Vector<const char*> r{"exp(s)", "cos(s)", "s^2"};
  const ExpressionCurve there = expression_curve(r, "0", "1");
  const ExpressionCurve back = expression_curve(r, "1", "0");
  for (const auto& rate :
       {length_rate(), curvature_rate(), torsion_rate(), bending_rate(), squared_torsion_rate()})
    CHECK(integral(there, rate).overlaps(integral(back, rate)));
  const RealBall up = integral(there, up_frame_rate({1, 2, 3}));
  CHECK(up.overlaps(integral(back, up_frame_rate({1, 2, 3}))));
  CHECK(sign(up) != 0);
}
