#include "phrame/ph/curve/formula_symmetry.hpp"

#include <doctest/doctest.h>

#include <string>

#include "phrame/ph/curve/formula_evaluation.hpp"
#include "support/expression_curves.hpp"

namespace formula_symmetry_test {

using namespace phrame;

namespace {

Formula formula(const std::string& text) { return parse_formula(text, "s").value; }

FormulaSymmetry symmetry(const std::string& text, const std::string& center) {
  return symmetry_about(formula(text), formula(center));
}

/// f at s.
RealBall value(const Formula& f, const Formula& s) {
  constexpr long bits = 128;
  FormulaProgram program;
  const auto at = program.insert(f, program.insert(s, program.number(0)));
  return constant_value(program, at, bits);
}

bool are_near(const RealBall& a, const RealBall& b) {
  return a.overlaps(b) && a.is_accurate(60) && b.is_accurate(60);
}

/// What the values at c ± h say, for two h.
void check_by_values(const std::string& text, const std::string& center) {
  CAPTURE(text);
  const Formula f = formula(text);
  const Formula c = formula(center);
  bool is_even = true;
  bool is_skew = true;
  for (const Rational& h : {Rational(1, 7), Rational(2, 5)}) {
    const RealBall after = value(f, c + Formula(h));
    const RealBall before = value(f, c - Formula(h));
    is_even = is_even && are_near(after, before);
    is_skew = is_skew && are_near(add(after, before, 128), times_power_of_two(value(f, c), 1));
  }
  const FormulaSymmetry found = symmetry_about(f, c);
  CHECK((found == FormulaSymmetry::constant) == (is_even && is_skew));
  CHECK((found == FormulaSymmetry::even) == (is_even && !is_skew));
  CHECK((found == FormulaSymmetry::skew) == (is_skew && !is_even));
}

}  // namespace

TEST_CASE("formula symmetry: what a form says is so, by values on both sides") {
  for (const char* text : {"2",
                           "s",
                           "3*s - 1",
                           "s^2",
                           "(s - pi)^2",
                           "(s - pi)^3 + 1",
                           "sin(s)",
                           "cos(s)",
                           "cos(3*s)*cos(2*s)",
                           "(2 + cos(3*s))*sin(2*s)",
                           "sin(3*s)",
                           "sin(s)*sin(2*s)",
                           "sin(s/2)",
                           "cos(s/2)",
                           "sin(s/3)",
                           "sin(s + 1)",
                           "exp(cos(s))",
                           "exp(s)",
                           "log(2 + cos(s))",
                           "sqrt(3 + sin(s)^2)",
                           "sqrt(5 + s)",
                           "atan(sin(s))",
                           "atan(s)",
                           "atan(cos(s))",
                           "sin(s)/(2 + cos(s))",
                           "1/(2 + sin(s))",
                           "(s - pi)*sin(s)",
                           "s*cos(s)",
                           "cos(s) + s",
                           "(2 + cos(s))^(1/2)",
                           "(2 + cos(s))^(-3)",
                           "sin(cos(s))",
                           "cos(sin(s))",
                           "sin(2*s)^3",
                           "pi*s - s*3",
                           "2*pi - s",
                           "cos(2*pi - s)"})
    check_by_values(text, "pi");
}

TEST_CASE("formula symmetry: about any point, and what is not seen is left open") {
  CHECK(symmetry("cos(s)", "0") == FormulaSymmetry::even);
  CHECK(symmetry("cos(s)", "pi/2") == FormulaSymmetry::skew);
  CHECK(symmetry("cos(s)", "pi/4") == FormulaSymmetry::unknown);
  CHECK(symmetry("cos(s)", "22/7") == FormulaSymmetry::unknown);
  CHECK(symmetry("cos(s - 1)", "1 + pi") == FormulaSymmetry::even);
  CHECK(symmetry("sin(pi*s)", "1/2") == FormulaSymmetry::even);
  CHECK(symmetry("s/sin(s)", "0") == FormulaSymmetry::unknown);  // not defined there
  CHECK(symmetry("sin(s)^(-1)", "0") == FormulaSymmetry::unknown);
  CHECK(symmetry("0*s", "1") != FormulaSymmetry::unknown);
}

// x is even about π, y and z are odd: half a turn about the x axis.
TEST_CASE("formula symmetry: half a turn takes a knot to itself, from end to start") {
  const ExpressionCurve knot = test::torus_knot(2, 3);
  CHECK(is_turned_over_by_half_turn(knot, {0, 0, 1}));
  CHECK(is_turned_over_by_half_turn(knot, {0, 2, -1}));
  CHECK(is_turned_over_by_half_turn(knot, {1, 0, 0}));
  CHECK_FALSE(is_turned_over_by_half_turn(knot, {1, 0, 1}));
  const auto curve = [](const char* x, const char* y, const char* z) {
    return test::expression_curve({x, y, z}, "0", "2*pi");
  };
  CHECK(is_turned_over_by_half_turn(curve("sin(s)", "cos(s)", "sin(2*s)"), {1, 0, 5}));
  CHECK(is_turned_over_by_half_turn(curve("sin(s)", "sin(3*s)", "cos(s)"), {0, 0, 1}));
  CHECK(is_turned_over_by_half_turn(curve("cos(s)", "sin(s)", "7"), {0, 0, 1}));
  // A reflection, a turn by less, another phase, and a part of the curve.
  CHECK_FALSE(is_turned_over_by_half_turn(curve("sin(s)", "cos(s)", "cos(2*s)"), {0, 0, 1}));
  CHECK_FALSE(is_turned_over_by_half_turn(curve("sin(s)", "sin(2*s)", "sin(3*s)"), {0, 0, 1}));
  CHECK_FALSE(is_turned_over_by_half_turn(curve("cos(s)", "sin(s)", "sin(3*s + 1)"), {0, 0, 1}));
  CHECK_FALSE(is_turned_over_by_half_turn(
      test::expression_curve({"cos(s)", "sin(s)", "sin(3*s)"}, "0", "6"), {0, 0, 1}));
}

}  // namespace formula_symmetry_test
