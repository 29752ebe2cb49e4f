#include "phrame/ph/along/expression_integral.hpp"

#include "phrame/algebra/ball_order.hpp"
#include "support/expression_curves.hpp"
#include "support/random.hpp"

using namespace phrame;
using test::expression_curve;
using test::torus_knot;

TEST_CASE("expression integral: the parts cover [0, 1], shorter where the curve turns sharply") {
  const ExpressionCurve c = expression_curve({"s", "sqrt(s^2 + 1e-6)", "0"}, "-1", "1");
  const auto found = taylor_parts(c, length_rate());
  REQUIRE_FALSE(found->fault);
  Rational at = 0;
  Rational shortest = 1;
  for (const TaylorPart& part : found->parts) {
    CHECK(part.lower == at);
    at = part.upper;
    shortest = std::min(shortest, Rational(part.upper - part.lower));
  }
  CHECK(at == 1);
  CHECK(shortest < Rational(1, 1000));
  CHECK(found->parts.size() < 300);
}

TEST_CASE("expression integral: where a factor is 0 the parts end, with the place") {
  const ExpressionCurve c = expression_curve({"s", "s^3", "0"}, "-1", "3");
  const auto found = taylor_parts(c, curvature_rate());  // κ = 0 at s = 0, t = 1/4
  REQUIRE(found->fault);
  const NarrowPart around = widened_part(*found->fault);
  CHECK(around.lower <= Rational(1, 4));
  CHECK(around.upper >= Rational(1, 4));
  CHECK(around.upper - around.lower < Rational(1, 1L << 30));
}

TEST_CASE("expression integral: law: narrow to the bits asked for, and each around the next") {
  const auto curve = [] { return expression_curve({"exp(s)", "s^2", "atan(3*s)"}, "-1", "2"); };
  const ExpressionIntegral length(curve(), length_rate());
  test::for_samples(5, [&](test::Random& random) {
    const Rational t(random.integer(0, 64), 64);
    const RealBall wide = length.enclose(t, 40);
    for (const long bits : {30L, 100L, 333L}) {
      const RealBall value = length.enclose(t, bits);
      CHECK(is_at_most(radius_of(value), times_power_of_two(RealBall(1, 2), -bits)));
      CHECK(value.overlaps(wide));
      // A fresh one, of other precision.
      CHECK(value.overlaps(ExpressionIntegral(curve(), length_rate()).enclose(t, bits / 2 + 7)));
    }
  });
  CHECK(length.enclose(0, 50).contains(0));
}

// The zeros of ρ are nearer than those of σ: there are parts with the smaller disc.
TEST_CASE("expression integral: law: so are those with ρ, by polynomials and by Gauss's rule") {
  const auto curve = [] { return expression_curve({"exp(s)", "s^2", "sin(3*s)"}, "-1", "1/2"); };
  const ExpressionCurve c = curve();
  for (const CurveIntegrand& y : {curvature_rate(), torsion_rate(), squared_torsion_rate()}) {
    const auto parts = taylor_parts(c, y)->parts;
    const auto small = std::find_if(parts.begin(), parts.end(), [](const TaylorPart& part) {
      return part.radius == least_radius;
    });
    REQUIRE(small != parts.end());
    const ExpressionIntegral integral(c, y);
    const RealBall end = integral.enclose(small->upper, 60);  // by points
    const Rational inside = small->upper - (small->upper - small->lower) / 1024;
    const RealBall near = integral.enclose(inside, 60);  // by a polynomial
    const RealBall rest = multiply(integral.rate(hull(inside, small->upper, 60), 60),
                                   RealBall(small->upper - inside, 60), 60);
    CHECK(end.overlaps(add(near, rest, 80)));
    for (const Rational& t : {inside, small->upper})
      for (const long bits : {20L, 90L, 200L}) {
        const RealBall value = ExpressionIntegral(curve(), y).enclose(t, bits);
        CHECK(is_at_most(radius_of(value), times_power_of_two(RealBall(1, 2), -bits)));
        CHECK(value.overlaps(integral.enclose(t, 150)));
      }
  }
}

TEST_CASE("expression integral: law: a line and a circle have the lengths that they have") {
  const auto length_of = [](const ExpressionCurve& c, const Rational& t) {
    return ExpressionIntegral(c, length_rate()).enclose(t, 200);
  };
  const ExpressionCurve line = expression_curve({"2*s", "3*s", "6*s"}, "1", "-1/2");
  CHECK(length_of(line, Rational(2, 3)).contains(7));
  const ExpressionCurve circle = expression_curve({"5*cos(s)", "5*sin(s)", "1"}, "0", "2*pi");
  CHECK(length_of(circle, Rational(1, 10)).overlaps(pi(300)));
}

namespace {

std::vector<CurveIntegrand> all_kinds() {
  return {length_rate(),  curvature_rate(),       torsion_rate(),
          bending_rate(), squared_torsion_rate(), up_frame_rate({1, 2, 3})};
}

}  // namespace

TEST_CASE("expression integral: parts are found once, for all copies of the curve and for −y") {
  const ExpressionCurve c = torus_knot(2, 3);
  const ExpressionCurve copy = c.turned_over();
  for (const CurveIntegrand& y : all_kinds()) {
    const auto found = taylor_parts(c, y);
    CHECK(taylor_parts(copy, y) == found);
    CHECK(taylor_parts(c, negative(y)) == found);
  }
  CHECK(taylor_parts(c, up_frame_rate({1, 2, 4})) != taylor_parts(c, up_frame_rate({1, 2, 3})));
}

TEST_CASE("expression integral: one that is held outlives what its curve keeps") {
  const ExpressionCurve c = expression_curve({"cos(s)", "sin(s)", "s"}, "0", "1");
  const auto angle = [&c](long k) { return ExpressionIntegral(c, up_frame_rate({1, 0, k})); };
  const ExpressionIntegral first = angle(4);
  const auto parts = taylor_parts(c, up_frame_rate({1, 0, 4}));
  const RealBall value = first.enclose(Rational(1, 3), 60);
  for (long k = 5; k < 75; ++k) angle(k);
  CHECK(taylor_parts(c, up_frame_rate({1, 0, 4})) != parts);  // found anew
  CHECK(first.enclose(Rational(1, 3), 100).overlaps(value));
  CHECK(angle(4).enclose(Rational(1, 3), 80).overlaps(value));
}

TEST_CASE("expression integral: law: found together they are what each is alone") {
  const auto curve = [] { return expression_curve({"exp(s)", "s^2", "sin(3*s)"}, "-1", "1/2"); };
  const ExpressionCurve together = curve();
  find_together(together, all_kinds());
  for (const CurveIntegrand& y : all_kinds()) {
    const ExpressionCurve alone = curve();
    const auto parts = taylor_parts(alone, y)->parts;
    const auto others = taylor_parts(together, y)->parts;
    REQUIRE(parts.size() == others.size());
    for (std::size_t k = 0; k < parts.size(); ++k) CHECK(parts[k].upper == others[k].upper);
    for (const Rational& t : {Rational(1), Rational(3, 7), Rational(1, 2)}) {
      const RealBall value = ExpressionIntegral(together, y).enclose(t, 150);
      CHECK(value.overlaps(ExpressionIntegral(alone, y).enclose(t, 90)));
      CHECK(is_at_most(radius_of(value), times_power_of_two(RealBall(1, 2), -150)));
      const RealBall opposite = ExpressionIntegral(together, negative(y)).enclose(t, 100);
      CHECK(add(value, opposite, 150).contains_zero());
    }
  }
}

// κ is 0 at s = 0: what is undefined there does not keep the others from being found.
TEST_CASE("expression integral: along an inflection the others are found together") {
  const ExpressionCurve c = expression_curve({"s", "s^3", "s^4"}, "-1", "3");
  find_together(c, all_kinds());
  CHECK(taylor_parts(c, torsion_rate())->fault);
  CHECK(taylor_parts(c, curvature_rate())->fault);
  CHECK_FALSE(taylor_parts(c, bending_rate())->fault);
  // mpmath: quad of |r′|, |r′ × r″|/|r′|², in parts that end at 0.
  const auto near = [&c](const CurveIntegrand& y, const char* digits) {
    const RealBall value = ExpressionIntegral(c, y).enclose(1, 80);
    const RealBall off = subtract(value, RealBall(parse_rational(digits), 120), 120);
    return is_less(absolute(off), RealBall(Rational(1, 1L << 60), 64));
  };
  CHECK(near(length_rate(), "88.258213303825575637656632903206"));
  CHECK(near(curvature_rate(), "3.3661046157264782651130961912368"));
}
