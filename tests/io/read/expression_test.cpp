#include "phrame/io/read/expression.hpp"

#include <fmt/format.h>

#include <chrono>
#include <cmath>

#include "phrame/algebra/error.hpp"
#include "phrame/io/write/text.hpp"
#include "support/random.hpp"

namespace expression_test {

using namespace phrame;
using test::for_samples;
using test::Random;

namespace {

RationalFunction value(std::string_view text) { return parse_expression(text).value; }
RationalFunction polynomial(Polynomial p) { return RationalFunction(std::move(p)); }
Rational number(std::string_view text) { return parse_expression(text, "").value(0); }

/// "place: reason" of the refusal; empty where there is none.
std::string refusal(std::string_view text, const std::optional<std::string>& variable = {},
                    const ExpressionLimits& limits = {}) {
  try {
    parse_expression(text, variable, limits);
  } catch (const InputError& error) {
    CHECK(std::string_view(error.what()).find('\n') == std::string_view::npos);
    return error.what();
  }
  return "";
}

std::string repeated(std::string_view text, int count) {
  std::string all;
  for (int k = 0; k < count; ++k) all += text;
  return all;
}

/// The text of a random expression, and its value computed step by step.
struct Sample {
  std::string text;
  RationalFunction value;
  int rank;  ///< 1 a sum, 2 a product, 3 with a sign, 4 a power, 5 what needs no parentheses
};

std::string blank(Random& random) { return random.chance(5) ? " " : ""; }

/// In parentheses where it binds weaker than `rank`, and sometimes where it does not.
std::string within(Random& random, const Sample& x, int rank) {
  std::string text = x.text;
  if (x.rank < rank) text = "(" + text + ")";
  while (random.chance(6)) text = fmt::format("({}{}{})", blank(random), text, blank(random));
  return text;
}

Sample leaf(Random& random) {
  if (random.chance(2)) return {"x", polynomial({0, 1}), 5};
  const long whole = random.integer(0, 30);
  if (random.chance(4))
    return {std::to_string(whole) + ".5e-1", polynomial({Rational(2 * whole + 1, 20)}), 5};
  return {std::to_string(whole), polynomial({Rational(whole)}), 5};
}

Sample power(Random& random, const Sample& base) {
  const long exponent = random.integer(base.value.is_zero() ? 1 : -3, 3);
  const RationalFunction factor =
      exponent < 0 ? RationalFunction(base.value.denominator(), base.value.numerator())
                   : base.value;
  RationalFunction result = polynomial({1});
  for (long k = 0; k < std::abs(exponent); ++k) result = result * factor;
  return {within(random, base, 5) + (random.chance(2) ? "^" : " ** ") + std::to_string(exponent),
          result, 4};
}

Sample sample(Random& random, int depth) {
  if (depth == 0) return leaf(random);
  Sample a = sample(random, depth - 1);
  const Sample b = sample(random, depth - 1);
  const std::string space = blank(random);
  switch (random.integer(0, 5)) {
    case 0:
      return {within(random, a, 1) + space + "+" + within(random, b, 2), a.value + b.value, 1};
    case 1:
      return {within(random, a, 1) + "-" + space + within(random, b, 2), a.value - b.value, 1};
    case 2:
      return {within(random, a, 2) + "*" + within(random, b, 3) + space, a.value * b.value, 2};
    case 3:
      if (b.value.is_zero()) return a;
      return {within(random, a, 2) + "/" + within(random, b, 3),
              a.value * RationalFunction(b.value.denominator(), b.value.numerator()), 2};
    case 4:
      return {"-" + within(random, a, 3), -a.value, 3};
    default:
      return power(random, a);
  }
}

}  // namespace

TEST_CASE("expressions: precedence is that of written mathematics") {
  CHECK(value("1 + 2*x^2") == polynomial({1, 0, 2}));
  CHECK(value("-x^2") == polynomial({0, 0, -1}));
  CHECK(value("(-x)^2") == polynomial({0, 0, 1}));
  CHECK(value("x - 1 - 2") == polynomial({-3, 1}));
  CHECK(value("x/2/3*4") == polynomial({0, Rational(2, 3)}));
  CHECK(value("2*-3*x - -x") == polynomial({0, -5}));
  CHECK(value("--+-x") == polynomial({0, -1}));
  CHECK(number("2^3^2") == 512);
  CHECK(number("(2^3)^2") == 64);
  CHECK(number("2^-1") == Rational(1, 2));
  CHECK(number("2^-1^2") == Rational(1, 2));
  CHECK(number("-2^2") == -4);
  CHECK(number("2^-2*3") == Rational(3, 4));
  CHECK(value("x^(2*3 - 1)") == polynomial({0, 0, 0, 0, 0, 1}));
  CHECK(value("x^-2") == RationalFunction({1}, {0, 0, 1}));
}

TEST_CASE("expressions: numbers are exact") {
  CHECK(number("0.1") == Rational(1, 10));
  CHECK(number("1.5e-3") == Rational(3, 2000));
  CHECK(number(".5") == Rational(1, 2));
  CHECK(number("3/7") == Rational(3, 7));
  CHECK(number("0x1.8p-3") == Rational(3, 16));
  CHECK(number("1e100000") == parse_rational("1e100000"));
  CHECK(number(std::string(100'000, '7')) == parse_rational(std::string(100'000, '7')));
}

TEST_CASE("expressions: quotients are in lowest terms") {
  CHECK(value("(x^2 - 1)/(x - 1)") == polynomial({1, 1}));
  CHECK(value("1/x + 1/(x + 1)") == RationalFunction({1, 2}, {0, 1, 1}));
  CHECK(value("1/(1/x + 1/x)") == polynomial({0, Rational(1, 2)}));
  CHECK(value("x/x") == polynomial({1}));
}

TEST_CASE("expressions: typeset signs and exponents are read") {
  CHECK(value("37·t⁴ − 72×t³ ÷ 2 + t⁻¹") == value("37*t^4 - 72*t^3/2 + t^-1"));
  CHECK(value("x**2") == value("x^2"));
  CHECK(value("-x²") == value("-(x^2)"));
  CHECK(value("(x + 1)¹⁰") == value("(x+1)^10"));
  constexpr auto ambiguous = "one exponent after another: parentheses are needed";
  CHECK(refusal("x²^3") == "column 3: " + std::string(ambiguous));
  CHECK(refusal("x^2³") == "column 4: " + std::string(ambiguous));
  CHECK(refusal("x² ³") == "column 4: " + std::string(ambiguous));
  CHECK(value("(x²)^3") == value("x^6"));
  CHECK(value("2^(x⁰)") == value("2"));
}

TEST_CASE("expressions: the variable is the one given or the one that occurs") {
  CHECK(parse_expression("t_1^2 + t_1").variable == "t_1");
  CHECK(parse_expression("θ - 1").variable == "θ");
  CHECK(parse_expression("2").variable.empty());
  CHECK(parse_expression("2", "t").variable == "t");
  CHECK(parse_expression("pi + 1", "pi").value == polynomial({1, 1}));
  CHECK(refusal("x + 1", "t") == "column 1: \"x\" is not the variable \"t\"");
  CHECK(refusal("1 + x", "") == "column 5: \"x\" where a number is expected");
  CHECK(refusal("x + 2*y") == "column 7: a second variable, \"y\" beside \"x\"");
  CHECK(refusal("x", "2") == "\"2\" is not the name of a variable");
  CHECK(refusal("x", "x y") == "\"x y\" is not the name of a variable");
}

TEST_CASE("expressions: a product without its sign is refused with advice") {
  const auto advice = [](const char* column, const char* left, const char* right,
                         const char* product) {
    return fmt::format(
        "column {}: no operator between \"{}\" and \"{}\": a product needs its sign, {}", column,
        left, right, product);
  };
  CHECK(refusal("2x") == advice("2", "2", "x", "2*x"));
  CHECK(refusal("1 + x(x + 1)") == advice("6", "x", "(", "x*(…)"));
  CHECK(refusal("(x)(x)") == advice("4", ")", "(", "(…)*(…)"));
  CHECK(refusal("x 3") == advice("3", "x", "3", "x*3"));
  CHECK(refusal("x² 3") == advice("4", "²", "3", "…²*3"));
  CHECK(refusal("4t(t − 1)") == advice("2", "4", "t", "4*t"));
}

TEST_CASE("expressions: a second variable is refused with what to do about it") {
  ExpressionLimits with_option;
  with_option.variable_option = "--var";
  CHECK(refusal("x + y", {}, with_option) ==
        "column 5: a second variable, \"y\" beside \"x\": write a number for one of them (--var "
        "names the variable)");
  CHECK(refusal("x + y", "x", with_option) ==
        "column 5: \"y\" is not the variable \"x\": write a number for it");
}

TEST_CASE("expressions: e, i and pi are alike: a variable only where they are given as one") {
  ExpressionLimits with_option;
  with_option.variable_option = "--var";
  for (const std::string name : {"e", "i", "pi", "π"}) {
    CAPTURE(name);
    const std::string reason = "column 1: \"" + name + "\" is not a rational number";
    CHECK(refusal(name + "^2") == reason);
    CHECK(refusal(name + "*x", "x") == reason);
    CHECK(refusal(name + "^2", {}, with_option) ==
          reason + "; --var " + name + " makes it the variable");
    CHECK(parse_expression(name + "^2", name).value == RationalFunction(Polynomial{0, 0, 1}));
    // As the variable it would leave another name to be refused.
    CHECK(refusal(name + "^2 + x", {}, with_option) == reason + ": write a number for it");
    CHECK(refusal(name + " / (2*\ntheta)", {}, with_option) == reason + ": write a number for it");
    CHECK(refusal(name + " + 2^" + name + "-$", {}, with_option) ==
          reason + "; --var " + name + " makes it the variable");
  }
  CHECK(refusal("1/(x^2+e)", {}, with_option) ==
        "column 8: \"e\" is not a rational number: write a number for it");
}

TEST_CASE("expressions: what is wrong is said with its column") {
  constexpr auto expected = " where a number, a variable or \"(\" is expected";
  CHECK(refusal("") == "column 1: the expression is empty");
  CHECK(refusal(" \t\n") == "column 4: the expression is empty");
  CHECK(refusal("x +") == "column 4: the expression ends" + std::string(expected));
  CHECK(refusal("*x") == "column 1: \"*\"" + std::string(expected));
  CHECK(refusal("θ² + ()") == "column 7: \")\"" + std::string(expected));
  CHECK(refusal("x//2") == "column 3: \"/\"" + std::string(expected));
  CHECK(refusal("1 + ((x) - 2") == "column 5: this \"(\" is never closed");
  CHECK(refusal("θ·x)") == "column 3: a second variable, \"x\" beside \"θ\"");
  CHECK(refusal("θ·2)") == "column 4: there is no \"(\" for this \")\"");
  CHECK(refusal("x = 1") == "column 3: \"=\" is not understood");
  CHECK(refusal("x\xC3") == "column 2: the byte 0xC3 is not understood");
  CHECK(refusal("1 + sin(x)") == "column 5: \"sin\": only rational functions are known");
  CHECK(refusal("x + pi") == "column 5: \"pi\" is not a rational number");
  CHECK(refusal("x + 1e100001") == "column 5: the exponent of 1e100001 exceeds 100000");
}

TEST_CASE("expressions: divisions by zero are found and named") {
  CHECK(refusal("1/0") == "column 3: division by zero: \"0\"");
  CHECK(refusal("x + 1/(x - x)") == "column 7: division by zero: \"(x - x)\"");
  CHECK(refusal("1/(1/(x + 1) - 1/(1 + x))") ==
        "column 3: division by zero: \"(1/(x + 1) - 1/(1 + x))\"");
  CHECK(refusal("2*0^-1") == "column 3: division by zero: \"0\" is 0, its exponent negative");
  CHECK(refusal("0⁻¹") == "column 1: division by zero: \"0\" is 0, its exponent negative");
  CHECK(refusal("(x-x)^0") == "column 1: 0 to the power 0 is undefined");
}

TEST_CASE("expressions: exponents are integers") {
  CHECK(refusal("x^(1/2)") == "column 3: the exponent 1/2 is not an integer");
  CHECK(refusal("2^x") == "column 3: the exponent \"x\" is not a number");
  CHECK(refusal("x⁻") == "column 2: \"⁻\" is not an exponent");
  CHECK(value("x^((x+1)/(x+1))") == polynomial({0, 1}));
}

TEST_CASE("expressions: what is beyond the limits is refused at once, whatever its size") {
  const auto degree = [](const std::string& what, const char* size) {
    return fmt::format("column 1: \"{}\": the degree {} exceeds the limit 1000", what, size);
  };
  const auto bits = [](const std::string& what) {
    return fmt::format("column 1: \"{}\": its numbers exceed the limit of 524288 bits", what);
  };
  CHECK(refusal("x^1000000000") == degree("x^1000000000", "1000000000"));
  CHECK(refusal("x^-1001") == degree("x^-1001", "1001"));
  CHECK(refusal("(x+1)^(10^9)") == degree("(x+1)^(10^9)", "1000000000"));
  CHECK(refusal("(x+1)^-1001") == degree("(x+1)^-1001", "1001"));
  CHECK(refusal("1/(x+1)^600 - 1/x^600") == degree("1/(x+1)^600 - 1/x^600", "1200"));
  CHECK(refusal("2^(10^12)") == bits("2^(10^12)"));
  CHECK(refusal("2^10^10^10") ==
        "column 3: \"10^10^10\": its numbers exceed the limit of 524288 "
        "bits");
  CHECK(refusal("(2/3)^-(10^12)") == bits("(2/3)^-(10^12)"));
  CHECK(refusal("x^3", {}, {100, {2}}) == "column 1: \"x^3\": the degree 3 exceeds the limit 2");
  CHECK(refusal("x + 1", {}, {4}) == "column 1: the expression has 5 bytes, the limit is 4");
  CHECK(number("(-1)^(10^12 + 1)") == -1);
  CHECK(value("((x+1)/(1+x))^1000000000") == polynomial({1}));
}

TEST_CASE("expressions: neither depth nor length is too much") {
  const std::string open(499'999, '(');
  CHECK(value(open + "x" + std::string(499'999, ')')) == polynomial({0, 1}));
  CHECK(refusal(std::string(1'000'000, '(')).starts_with("column 1000001: the expression ends"));
  CHECK(value(std::string(999'998, '-') + "x") == polynomial({0, 1}));
  CHECK(number("1" + repeated("^1", 100'000)) == 1);
  CHECK(value("x" + repeated("+x", 100'000)) == polynomial({0, 100'001}));
  CHECK(value("1/x" + repeated("*x/x", 100'000)) == value("1/x"));
}

TEST_CASE("expressions: long ones of degree 1000 take milliseconds") {
  std::string sum = "0";
  std::string product = "1";
  std::string nested = "1";
  std::string fractions = "0";
  for (int k = 1; k <= 1000; ++k) {
    sum += fmt::format(" + {}/{}*x^{}", 7 * k + 1, 9 * k + 2, k);
    nested = fmt::format("({}*x + {})", nested, k);
    product += fmt::format("*(x - {})", k);
    if (k <= 300) fractions += fmt::format(" - 1/(x - {})", k);
  }
  const auto start = std::chrono::steady_clock::now();
  CHECK(value(sum).numerator().degree() == 1000);
  CHECK(value(nested).numerator().coefficient(1) == 999);
  CHECK(value(product).numerator()(500) == 0);
  CHECK(value(fractions).denominator().degree() == 300);
  // A bound that a slow machine or a sanitizer keeps; without care it is minutes.
  CHECK(std::chrono::steady_clock::now() - start < std::chrono::seconds(20));
}

TEST_CASE("expressions: law: a text means what its operations compute") {
  for_samples(400, [](Random& random) {
    const Sample s = sample(random, static_cast<int>(random.integer(0, 4)));
    CAPTURE(s.text);
    REQUIRE(refusal(s.text, "x") == "");
    CHECK(parse_expression(s.text, "x").value == s.value);
  });
}

TEST_CASE(
    "expressions: law: a polynomial is read from its coefficients, however they are written") {
  for_samples(200, [](Random& random) {
    const Polynomial p = random.polynomial(8);
    const Polynomial q = random.nonzero_polynomial(8);
    const auto written = [&](const Polynomial& f) {
      std::string text = "0";
      for (long k = f.degree(); k >= 0; --k)
        text += fmt::format("{}{}*t^{}", random.chance(2) ? " + " : "+",
                            formatted(f.coefficient(k), Notation::unicode), k);
      return text;
    };
    CHECK(value(fmt::format("({})/({})", written(p), written(q))) == RationalFunction(p, q));
  });
}

}  // namespace expression_test
