#include "phrame/ph/curve/formula_program.hpp"

#include "phrame/io/read/formula.hpp"
#include "phrame/ph/curve/formula_evaluation.hpp"
#include "support/random.hpp"

using namespace phrame;

namespace {

Formula read(std::string_view text) { return parse_formula(text, "s").value; }

/// The value at s = a + bπ as one step.
std::size_t at(FormulaProgram& program, std::string_view text, const Rational& a,
               const Rational& b) {
  return program.insert(read(text), program.number(a, b));
}

}  // namespace

TEST_CASE("formula program: no value is found twice") {
  FormulaProgram program;
  const auto s = program.variable();
  const auto x = program.insert(read("cos(3*s)*(2 + sin(s))"), s);
  const auto steps = program.steps().size();
  CHECK(program.insert(read("(sin(s) + 2)*cos(s*3)"), s) == x);
  CHECK(program.steps().size() == steps);
}

TEST_CASE("formula program: what is periodic has one value at both ends of a period") {
  for (const auto* text : {"(2 + cos(3*s))*cos(2*s)", "exp(sin(s)/3)", "s*sin(4*s) - s*sin(2*s)",
                           "atan(cos(5*s))^2/(3 + sin(s + 1))", "sqrt(2 + cos(s + pi/7))"}) {
    CAPTURE(text);
    FormulaProgram program;
    CHECK(at(program, text, 0, 0) == at(program, text, 0, 2));
  }
  FormulaProgram program;
  CHECK(at(program, "sin(s)", 1, 0) == at(program, "sin(s)", 1, 4));
  CHECK(at(program, "sin(s/2)", 1, 0) != at(program, "sin(s/2)", 1, 2));
  CHECK(at(program, "-sin(s/2)", 1, 0) == at(program, "sin(s/2)", 1, 2));
  CHECK(at(program, "sin(s)", 0, Rational(1, 5)) == at(program, "sin(s)", 0, Rational(4, 5)));
  CHECK(at(program, "cos(s)", 0, Rational(1, 5)) == at(program, "sin(s)", 0, Rational(3, 10)));
}

TEST_CASE("formula program: sines and cosines of simple angles are rational") {
  const auto value = [](std::string_view text, const Rational& turns) {
    FormulaProgram program;
    const Rational* known = program.rational(at(program, text, 0, turns));
    return known == nullptr ? Rational(99) : *known;
  };
  CHECK(value("sin(s)", 0) == 0);
  CHECK(value("sin(s)", Rational(1, 6)) == Rational(1, 2));
  CHECK(value("sin(s)", Rational(3, 2)) == -1);
  CHECK(value("cos(s)", Rational(2, 3)) == Rational(-1, 2));
  CHECK(value("cos(s)", Rational(-5, 3)) == Rational(1, 2));
  CHECK(value("cos(s)", Rational(1, 4)) == 99);
  CHECK(value("cos(s) - sin(s)", Rational(1, 4)) == 0);
  CHECK(value("sqrt(sin(s)/2)", Rational(5, 6)) == Rational(1, 2));
  CHECK(value("exp(sin(s)) + log(cos(2*s)) + atan(0)", 1) == 1);
  CHECK(value("s/pi", Rational(7, 3)) == Rational(7, 3));
  CHECK(value("(s/pi)^-3", Rational(2)) == Rational(1, 8));
  CHECK(value("0*s + s^0", Rational(2)) == 1);
}

TEST_CASE(
    "formula program: sums of roots, with π or not, and denominators that cancel, are exact") {
  FormulaProgram program;
  const auto value = [&](std::string_view text) { return at(program, text, 0, 0); };
  const auto same = [&](std::string_view a, std::string_view b) { return value(a) == value(b); };
  CHECK(same("sqrt(2)*(2*pi/sqrt(2))", "2*pi"));
  CHECK(same("sqrt(8) + 3", "2*sqrt(2) + 3"));
  CHECK(same("sqrt(2)*sqrt(3)", "sqrt(6)"));
  CHECK(same("1/(sqrt(5) - 2)", "sqrt(5) + 2"));
  CHECK(same("(1 + sqrt(2))^3", "7 + 5*sqrt(2)"));
  CHECK(same("(sqrt(3)*pi)/(sqrt(12)*pi)", "1/2"));
  CHECK(same("sin(pi/3)", "sqrt(3)/2"));
  CHECK(same("cos(3*pi/4)", "-1/sqrt(2)"));
  CHECK(same("sin(pi/12)*4", "sqrt(6) - sqrt(2)"));
  CHECK(same("cos(pi/5)", "(1 + sqrt(5))/4"));
  CHECK(same("-sin(13*pi/10)", "cos(pi/5)"));
  CHECK(same("atan(-sqrt(3))", "-pi/3"));
  CHECK(same("atan(2 - 3^(1/2))", "pi/12"));
  CHECK(same("2*exp(1)*(5*pi/exp(1))", "10*pi"));
  CHECK_FALSE(same("sqrt(2) + sqrt(3)", "sqrt(5 + 24^(1/2) + 2^-200)"));
  CHECK_FALSE(same("sqrt(2)*pi", "sqrt(2)*pi + 2^-200*sqrt(3)"));
  CHECK_FALSE(constant_value(program, value("1/(sqrt(2)*sqrt(8) - 4)"), 64).is_finite());
  CHECK_FALSE(constant_value(program, value("sqrt(1 - sqrt(2))"), 64).is_finite());
}

TEST_CASE("formula program: law: numbers of its own arithmetic are those of balls") {
  const std::vector<std::string> leaves{"2",          "1/3",       "sqrt(2)",
                                        "sqrt(3)",    "pi",        "sin(pi/12)",
                                        "cos(pi/10)", "sqrt(2/3)", "atan(1/sqrt(3))"};
  const std::vector<std::string> operations{"+", "-", "*", "/"};
  test::for_samples(200, [&](test::Random& random) {
    std::string text = "1";
    for (long k = random.integer(1, 5); k > 0; --k)
      text = "(" + text + operations[static_cast<std::size_t>(random.integer(0, 3))] +
             leaves[static_cast<std::size_t>(random.integer(0, 8))] + ")";
    CAPTURE(text);
    FormulaProgram program;
    const RealBall exact = constant_value(program, at(program, text, 0, 0), 128);
    const RealBall plain = evaluate_steps(read(text).steps(), BallPolynomial({RealBall()}), 1, 128)
                               .back()
                               .coefficient(0);
    CHECK(exact.is_finite());
    CHECK(exact.overlaps(plain));
  });
}

TEST_CASE("formula program: a division by 0 and a root of -1 remain") {
  FormulaProgram program;
  for (const auto* text : {"1/(s - 1)", "sqrt(-s)", "log(s - 1)", "(s - 1)^-2"}) {
    CAPTURE(text);
    const auto step = at(program, text, 1, 0);
    CHECK(program.rational(step) == nullptr);
    CHECK_FALSE(constant_value(program, step, 64).is_finite());
  }
}

TEST_CASE("formula program: towers of products do not grow out of hand") {
  std::string text = "7";
  for (int k = 0; k < 30; ++k) text = "(" + text + ")^90";
  FormulaProgram program;
  CHECK(program.rational(program.insert(read(text), program.variable())) == nullptr);
}

TEST_CASE("formula program: law: derivatives are those of the Taylor series") {
  for (const auto* text :
       {"s^3 - 2*s", "sin(s)*cos(3*s)", "exp(-s^2/2)/(1 + s^2)", "log(2 + s)*sqrt(1 + s)",
        "atan(s/3)^2", "(1 + s)^(-2/3)", "tan(s)/7", "s^-3", "pi*s + 1"}) {
    CAPTURE(text);
    constexpr long bits = 128;
    const RealBall s(Rational(2, 5), bits);
    const auto value = [&](const Formula& f, long length) {
      return evaluate_steps(f.steps(), BallPolynomial({s, RealBall(1, bits)}), length, bits).back();
    };
    const RealBall slope = value(derivative(read(text)), 1).coefficient(0);
    CHECK(slope.overlaps(value(read(text), 2).coefficient(1)));
    CHECK(slope.accuracy_bits() > 100);
  }
}
