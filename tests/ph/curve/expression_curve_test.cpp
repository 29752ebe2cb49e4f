#include "phrame/ph/curve/expression_curve.hpp"
#include "phrame/algebra/ball_polynomial.hpp"
#include "phrame/algebra/error.hpp"

#include "phrame/algebra/ball.hpp"
#include "phrame/algebra/complex_series.hpp"
#include "phrame/io/read/formula.hpp"
#include "phrame/ph/curve/exact_vector.hpp"
#include "support/expression_curves.hpp"
#include "support/refusal.hpp"

using namespace phrame;
using test::expression_curve;

TEST_CASE("expression curve: its series are those of the formulas along t") {
  const ExpressionCurve c = expression_curve({"s^2", "s^3", "s"}, "1", "3");
  const auto r = c.series(RealBall(Rational(1, 2), 64), Rational(1, 2), 4, 64);  // s = 2 + z
  for (long k = 0; k < 4; ++k) {
    CHECK(r[0].coefficient(k).contains(Polynomial{4, 4, 1}.coefficient(k)));
    CHECK(r[1].coefficient(k).contains(Polynomial{8, 12, 6, 1}.coefficient(k)));
    CHECK(r[2].coefficient(k).contains(Polynomial{2, 1}.coefficient(k)));
  }
  CHECK(c.parameter(RealBall(Rational(1, 4), 64), 64).contains(Rational(3, 2)));
  const auto z = c.series(ComplexBall(RealBall(Rational(1, 2), 64), {}), 1, 2, 64);
  CHECK(z[0].coefficient(1).re().contains(8));
}

TEST_CASE("expression curve: where its ends meet, exactly, is seen by their form") {
  const auto meets = [](const Vector<const char*>& r, const char* from, const char* to) {
    const ExpressionCurve c = expression_curve(r, from, to);
    FormulaProgram program;
    return are_equal(program, exact_point(c, 0, program), exact_point(c, 1, program));
  };
  const Vector<const char*> trefoil{"(2 + cos(3*s))*cos(2*s)", "(2 + cos(3*s))*sin(2*s)",
                                    "sin(3*s)"};
  CHECK(meets(trefoil, "0", "2*pi") == true);
  CHECK(meets(trefoil, "1/3 - pi", "1/3 + pi") == true);
  CHECK(meets(trefoil, "0", "pi") == false);
  CHECK(meets(trefoil, "0", "6.283185307179586476925286766559") == false);
  // (√2 + √3)² = 5 + 2√6
  CHECK(meets({"s*(s - (sqrt(2) + sqrt(3))^2 + 5)", "s*(s - 2*sqrt(6))", "sin(s*pi/sqrt(6))"}, "0",
              "2*sqrt(6)") == true);
  // √(5 + 2√6) = √2 + √3: no form that is known.
  CHECK(meets({"s*(s - sqrt(5 + 2*sqrt(6)))", "s", "0"}, "0", "sqrt(2) + sqrt(3)") == false);
  CHECK(meets({"s*(s - sqrt(5 + 2*sqrt(6)))", "s^2*(s - sqrt(2) - sqrt(3))", "0"}, "0",
              "sqrt(2) + sqrt(3)") == std::nullopt);
}

TEST_CASE("expression curve: directions agree up to a positive factor") {
  const auto agree = [](const ExpressionCurve& c, const ExpressionCurve& d) {
    FormulaProgram program;
    return have_same_direction(program, exact_direction(c, 1, program),
                               exact_direction(d, 0, program));
  };
  const ExpressionCurve line = expression_curve({"s", "2*s", "3*s"}, "0", "1");
  CHECK(agree(line, expression_curve({"s", "2*s", "3*s"}, "1", "9")) == true);
  CHECK(agree(line, expression_curve({"s", "2*s", "3*s"}, "1", "0")) == false);
  CHECK(agree(line, expression_curve({"s", "2*s", "4*s"}, "1", "2")) == false);
  const ExpressionCurve circle = expression_curve({"cos(s)", "sin(s)", "0"}, "0", "2*pi");
  CHECK(agree(circle, circle) == true);
  CHECK(agree(circle, expression_curve({"2*cos(3*s)", "2*sin(3*s)", "0"}, "0", "1")) == true);
  CHECK(agree(circle, expression_curve({"2*cos(3*s)", "-2*sin(3*s)", "0"}, "0", "1")) == false);
}

// s*2^(10^9) aborted where memory was short, the others took minutes.
TEST_CASE("expression curve: what is too large or too small to compute with is refused at once") {
  const auto refusal = [](const char* x, const char* y) {
    return test::refusal_of<DomainError>([&] { expression_curve({x, y, "0"}, "0", "1"); });
  };
  CHECK(refusal("s*2^(5*10^5*2)", "s") ==
        "2^1000000 is at least 2^1000000 at t = 0: what is computed with is less than 2^20000");
  CHECK(refusal("1.5^999999*s", "s").starts_with("(3/2)^999999 is at least 2^5849"));
  CHECK(
      refusal("exp(10^5*s*(1 - s))", "s").starts_with("exp(100000*s*(1 - s)) is at least 2^3606"));
  CHECK(refusal("exp(exp(exp(30*s)))", "s").starts_with("exp(exp(30*s)) is at least 2^471"));
  CHECK(
      refusal("((((2^400)^400)^400)^400)*s", "s").starts_with("(2^400)^400 is at least 2^160000"));
  CHECK(
      refusal("2^1100*sin(s)", "s").starts_with("the change of 2^1100*sin(s) is at least 2^1100"));
  CHECK(refusal("sin(s)*2^-2000", "s^2*2^-2000").starts_with("the speed is less than 2^-1024"));
  CHECK(refusal("2^900*sin(s)", "2^-2000*s").empty());
}
