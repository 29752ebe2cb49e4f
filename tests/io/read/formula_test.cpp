#include "phrame/io/read/formula.hpp"

#include "phrame/algebra/error.hpp"
#include "phrame/ph/curve/formula_evaluation.hpp"
#include "support/random.hpp"

namespace formula_test {

using namespace phrame;

namespace {

std::string again(std::string_view text) {
  const GivenFormula given = parse_formula(text);
  return to_string(given.value, given.variable);
}

std::string failure(std::string_view text, const std::optional<std::string>& variable = "s") {
  try {
    parse_formula(text, variable);
  } catch (const InputError& error) {
    return error.what();
  }
  return "none";
}

/// A value of it, to 15 digits.
std::string value(std::string_view text) {
  return to_string(constant_value(parse_formula(text, "").value, 64), 15);
}

}  // namespace

TEST_CASE("parse_formula: precedence is that of algebra") {
  CHECK(again("2+3*s^2") == "2 + 3*s^2");
  CHECK(again("(2+3)*s") == "(2 + 3)*s");
  CHECK(again("-s^2") == "-s^2");
  CHECK(again("(-s)^2") == "(-s)^2");
  CHECK(again("s^-1/2") == "s^(-1)/2");
  CHECK(again("s^(2/3)") == "s^(2/3)");
  CHECK(again("s^2^3") == "s^8");
  CHECK(again("2 - 3 - s") == "2 - 3 - s");
  CHECK(again("s/2/3") == "s/2/3");
  CHECK(again("sin ( 2·π·t ) ÷ 3") == "sin(2*pi*t)/3");
  CHECK(again("cos(u)²") == "cos(u)^2");
  CHECK(again("s**3 − +1") == "s^3 - 1");
}

// The values are mpmath's.
TEST_CASE("parse_formula: functions and constants are what their names say") {
  CHECK(value("sin(1) + cos(2) + tan(3)") == "0.282777605186476");
  CHECK(value("cot(1) - sec(2) + csc(3)") == "10.1312579733939");
  CHECK(value("exp(1.5) + log(2) + ln(3)") == "6.27344853956612");
  CHECK(value("sqrt(2) + asin(1/3) + acos(1/4)") == "3.07216654348003");
  CHECK(value("atan(2) - arctan(3)") == "-0.141897054604164");
  CHECK(value("sinh(1) + cosh(2) + tanh(3)") == "5.93245163841416");
  CHECK(value("2^0.5 + 2^pi + e^2 + 8^(1/3)") == "19.6282474883800");
  CHECK(value("0x1.8p1 + 1e-1 + .5") == "3.60000000000000");
}

TEST_CASE("parse_formula: the variable is the one given, or the only other name") {
  CHECK(parse_formula("sin(phi) + phi").variable == "phi");
  CHECK(parse_formula("2*pi").variable.empty());
  CHECK(parse_formula("e*e", "e").variable == "e");
  CHECK(to_string(parse_formula("e + 1", "e").value, "e") == "e + 1");
  CHECK(failure("s + t") == "column 5: \"t\" is not the variable \"s\"");
  CHECK(failure("a + b", std::nullopt) == "column 5: a second variable, \"b\" beside \"a\"");
  CHECK(failure("2*s", "") == "column 3: \"s\" where a number is expected");
}

TEST_CASE("parse_formula: what is wrong is named, with its column") {
  CHECK(failure("") == "column 1: the expression is empty");
  CHECK(
      failure("2*") ==
      "column 3: the expression ends where a number, a variable, a function or \"(\" is expected");
  CHECK(failure("2s") ==
        "column 2: no operator between \"2\" and \"s\": a product needs its sign, *");
  CHECK(failure("s(2)") ==
        "column 2: no operator between \"s\" and \"(\": a product needs its sign, *");
  CHECK(failure("sin s") == "column 1: the function sin needs its argument in parentheses: sin(…)");
  CHECK(failure("1 + foo(s)").substr(0, 42) == "column 5: \"foo\" is not a function that is ");
  CHECK(failure("(s + 1") == "column 1: this \"(\" is never closed");
  CHECK(failure("cos(s") == "column 1: this \"(\" is never closed");
  CHECK(failure("s + 1)") == "column 6: there is no \"(\" for this \")\"");
  CHECK(failure("1/(2 - 2)") == "column 3: division by zero");
  CHECK(failure("s^1e9").substr(0, 35) == "column 3: the exponent 1000000000 i");
  CHECK(failure("2^(10^9)*s").substr(0, 35) == "column 3: the exponent 1000000000 i");
  CHECK(failure("s²^3") == "column 3: one exponent after another: parentheses are needed");
  CHECK(failure("sin()") ==
        "column 5: \")\" where a number, a variable, a function or \"(\" is expected");
  CHECK(failure("s § 2") == "column 3: \"§\" is not understood");
  CHECK(failure(std::string(max_formula_length + 1, '1')).substr(0, 34) ==
        "column 1: the expression has 10000");
}

TEST_CASE("parse_formula: no depth and no length is too much") {
  std::string deep;
  for (int k = 0; k < 20'000; ++k) deep += "-sin(";
  CHECK(failure(deep).substr(0, 14) == "column 100001:");
  std::string longer = "s";
  for (int k = 0; k < 30'000; ++k) longer += "+s";
  CHECK(parse_formula(longer).value.steps().size() == 60'001);
  std::string huge = "1";
  for (int k = 0; k < 2'000; ++k) huge += "*1e999";
  CHECK(parse_formula(huge).variable.empty());
  CHECK(failure("1e99999").substr(0, 29) == "column 1: the number 1e99999 ");
}

}  // namespace formula_test
