#include "phrame/ph/curve/formula.hpp"

#include "phrame/algebra/error.hpp"
#include "phrame/ph/curve/formula_evaluation.hpp"
#include "support/random.hpp"

using namespace phrame;

TEST_CASE("formula: it is written as it is read, with parentheses where they are needed") {
  const Formula s = Formula::variable();
  CHECK(to_string((Formula(2) + cos(Formula(3) * s)) * sin(s), "s") == "(2 + cos(3*s))*sin(s)");
  CHECK(to_string(power(s + Formula(1), Rational(2, 3)), "u") == "(u + 1)^(2/3)");
  CHECK(to_string(Formula(1) / (s * s), "s") == "1/(s*s)");
  CHECK(to_string(-exp(s), "s") == "-exp(s)");
  CHECK(to_string(Formula(0, 2), "s") == "2*pi");
  CHECK(to_string(Formula(1, Rational(1, 3)), "s") == "1 + 1/3*pi");
}

TEST_CASE("formula: of a long one the middle is left out, between characters") {
  Formula sum = Formula::variable();
  for (int k = 0; k < 40; ++k) sum = sum + Formula::variable();
  const std::string text = to_string(sum, "θ");
  CHECK(text.size() < 70);
  CHECK(text.find("…") != std::string::npos);
  CHECK(text.substr(0, 4) == "θ +");
}

TEST_CASE("formula: constant is what does not name the variable") {
  CHECK(is_constant(sin(Formula(0, 1))));
  CHECK_FALSE(is_constant(Formula(0) * Formula::variable()));
}

TEST_CASE("formula: an exponent has a limit") {
  CHECK_THROWS_AS(power(Formula::variable(), Rational(1'000'001)), DomainError);
  CHECK_THROWS_AS(power(Formula::variable(), Rational(1, 1'000'001)), DomainError);
  CHECK_NOTHROW(power(Formula::variable(), Rational(-1'000'000)));
}

TEST_CASE("formula: law: the operations are those of numbers") {
  test::for_samples(50, [](test::Random& random) {
    const Rational a = random.rational();
    const Rational b = random.rational();
    const auto value = [](const Formula& f) { return constant_value(f, 64); };
    CHECK(value(Formula(a) + Formula(b)).contains(a + b));
    CHECK(value(Formula(a) - Formula(b)).contains(a - b));
    CHECK(value(Formula(a) * Formula(b)).contains(a * b));
    CHECK(value(power(Formula(a), 3)).contains(a * a * a));
    if (b != 0) CHECK(value(Formula(a) / Formula(b)).contains(a / b));
    if (a != 0) CHECK(value(exp(log(Formula(a * a)))).contains(a * a));
    if (a != 0) CHECK(value(sqrt(Formula(a * a))).contains(abs(a)));
    CHECK(value(tan(atan(Formula(a)))).contains(a));
  });
}
