#include "phrame/ph/smooth/expression_integral.hpp"

#include "phrame/algebra/ball_order.hpp"
#include "phrame/ph/smooth/curve_integrands.hpp"
#include "support/expression_curves.hpp"
#include "support/random.hpp"

using namespace phrame;
using test::expression_curve;

TEST_CASE("expression integral: the parts cover [0, 1], shorter where the curve turns sharply") {
  const ExpressionCurve c = expression_curve({"s", "sqrt(s^2 + 1e-6)", "0"}, "-1", "1");
  const TaylorParts found = taylor_parts(c, length_rate());
  REQUIRE_FALSE(found.fault);
  Rational at = 0;
  Rational shortest = 1;
  for (const TaylorPart& part : found.parts) {
    CHECK(part.lower == at);
    at = part.upper;
    shortest = std::min(shortest, Rational(part.upper - part.lower));
  }
  CHECK(at == 1);
  CHECK(shortest < Rational(1, 1000));
  CHECK(found.parts.size() < 300);
}

TEST_CASE("expression integral: where a factor is 0 the parts end, with the place") {
  const ExpressionCurve c = expression_curve({"s", "s^3", "0"}, "-1", "3");
  const TaylorParts found = taylor_parts(c, curvature_rate());  // κ = 0 at s = 0, t = 1/4
  REQUIRE(found.fault);
  const NarrowPart around = widened_part(*found.fault);
  CHECK(around.lower <= Rational(1, 4));
  CHECK(around.upper >= Rational(1, 4));
  CHECK(around.upper - around.lower < Rational(1, 1L << 30));
}

TEST_CASE("expression integral: law: narrow to the bits asked for, and each around the next") {
  const ExpressionCurve c = expression_curve({"exp(s)", "s^2", "atan(3*s)"}, "-1", "2");
  const ExpressionIntegral length(c, length_rate(), regular_parts(c));
  test::for_samples(5, [&](test::Random& random) {
    const Rational t(random.integer(0, 64), 64);
    const RealBall wide = length.enclose(t, 40);
    for (const long bits : {30L, 100L, 333L}) {
      const RealBall value = length.enclose(t, bits);
      CHECK(is_at_most(radius_of(value), times_power_of_two(RealBall(1, 2), -bits)));
      CHECK(value.overlaps(wide));
      // A fresh one, of other precision.
      CHECK(value.overlaps(
          ExpressionIntegral(c, length_rate(), regular_parts(c)).enclose(t, bits / 2 + 7)));
    }
  });
  CHECK(length.enclose(0, 50).contains(0));
}

TEST_CASE("expression integral: law: a line and a circle have the lengths that they have") {
  const auto length_of = [](const ExpressionCurve& c, const Rational& t) {
    return ExpressionIntegral(c, length_rate(), regular_parts(c)).enclose(t, 200);
  };
  const ExpressionCurve line = expression_curve({"2*s", "3*s", "6*s"}, "1", "-1/2");
  CHECK(length_of(line, Rational(2, 3)).contains(7));
  const ExpressionCurve circle = expression_curve({"5*cos(s)", "5*sin(s)", "1"}, "0", "2*pi");
  CHECK(length_of(circle, Rational(1, 10)).overlaps(pi(300)));
}
