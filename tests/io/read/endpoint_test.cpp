#include "phrame/io/read/endpoint.hpp"

#include <doctest/doctest.h>

#include "phrame/algebra/error.hpp"
#include "phrame/integrate/endpoint.hpp"
#include "support/refusal.hpp"

namespace endpoint_test {

using namespace phrame;

namespace {

std::string refusal(std::string_view text) {
  return test::refusal_of([&] { parse_endpoint(text); });
}

Rational rational(std::string_view text) { return std::get<Rational>(parse_endpoint(text)); }

}  // namespace

TEST_CASE("endpoints: rational numbers are computed exactly") {
  CHECK(rational("3/7") == Rational(3, 7));
  CHECK(rational("-2") == -2);
  CHECK(rational(" 1e-3 ") == Rational(1, 1000));
  CHECK(rational("(1+2)/3") == 1);
  CHECK(rational("2^-3") == Rational(1, 8));
}

TEST_CASE("endpoints: infinity has two signs and several names") {
  for (const char* text : {"inf", "+inf", "infinity", "oo", "∞", " + ∞ "})
    CHECK(std::get<Infinity>(parse_endpoint(text)) == Infinity::positive);
  for (const char* text : {"-inf", "- infinity", "-oo", "-∞", "−∞"})
    CHECK(std::get<Infinity>(parse_endpoint(text)) == Infinity::negative);
  CHECK(refusal("1 + inf") == "column 5: \"inf\" is not a rational number");
  CHECK(refusal("inf inf") == "column 1: \"inf\" is not a rational number");
}

TEST_CASE("endpoints: a root is the one root of its polynomial between two ends") {
  const auto root = std::get<RealAlgebraic>(parse_endpoint(" root ( (t^2-2)^3*(t-7) , 1, 4/2 ) "));
  CHECK(root == real_root({-2, 0, 1}, closed_interval(1, 2)));
  CHECK(std::get<RealAlgebraic>(parse_endpoint("root(x^3 - 2, -inf, ∞)")).polynomial() ==
        Polynomial{-2, 0, 0, 1});
  CHECK(rational("root(3*x - 1, 0, 1)") == Rational(1, 3));
  CHECK(rational("root(x^2/2 - x, 1, 2)") == 2);
}

TEST_CASE("endpoints: no root or several are refused with their number") {
  CHECK(refusal("root(x^2-2, -2, 2)") == "column 1: x² − 2 has 2 real roots in [-2, 2], not one");
  CHECK(refusal("root(x^2+2, -2, 2)") == "column 1: x² + 2 has no real roots in [-2, 2], not one");
  CHECK(refusal("root(x-1, 3, 0)") ==
        "column 1: the first end of the interval is greater than the second");
  CHECK(refusal("root(5, 0, 1)") == "column 1: 5 has no real roots in [0, 1], not one");
}

TEST_CASE("endpoints: what is wrong is said with its column in the whole text") {
  constexpr auto form = "a root is given by a polynomial and two ends, as in root(x^2-2, 1, 2)";
  CHECK(refusal("") == "column 1: the expression is empty");
  CHECK(refusal("x") == "column 1: \"x\" where a number is expected");
  CHECK(refusal("1/0") == "column 3: division by zero: \"0\"");
  CHECK(refusal("root(x^2-2, 1)") == std::string("column 1: ") + form);
  CHECK(refusal("root(x, 1, 2, 3)") == std::string("column 1: ") + form);
  CHECK(refusal("root()") == std::string("column 1: ") + form);
  CHECK(refusal("root(x^2-2, 1, 2") == "column 5: this \"(\" is never closed");
  CHECK(refusal("root(x^2-2, 1, 2) + 1") == "column 19: nothing may follow a root");
  CHECK(refusal("root(x^2-2, 1, 2))") == "column 17: there is no \"(\" for this \")\"");
  CHECK(refusal("root(θ²+, 1, 2)") ==
        "column 9: the expression ends where a number, a variable or \"(\" is expected");
  CHECK(refusal("root(θ²-2, y, 2)") == "column 12: \"y\" where a number is expected");
  CHECK(refusal("root(x-2, 1, 1/0)") == "column 16: division by zero: \"0\"");
  CHECK(refusal("root(1/x, 1, 2)") == "column 6: this is not a polynomial");
  CHECK(refusal("root( x-x, 1, 2)") == "column 7: the zero polynomial vanishes everywhere");
  CHECK(refusal("root(x, inf, 2)") == "column 9: the interval is empty");
  CHECK(refusal("root") == "column 1: \"root\": only rational functions are known");
}

TEST_CASE("endpoints: square roots are algebraic numbers") {
  const auto algebraic = [](std::string_view text) {
    return std::get<RealAlgebraic>(parse_endpoint(text));
  };
  CHECK(algebraic("sqrt(2)") == real_root({-2, 0, 1}, closed_interval(1, 2)));
  CHECK(algebraic("-√2") == real_root({-2, 0, 1}, closed_interval(-2, -1)));
  CHECK(algebraic("(1+sqrt(5))/2") == real_root({-1, -1, 1}, closed_interval(1, 2)));
  CHECK(algebraic("1/(sqrt(3) - 1)") == real_root({-1, -2, 2}, closed_interval(1, 2)));
  CHECK(algebraic("sqrt( 1/2 )*√(1/2)*√(1/2)") == real_root({-1, 0, 8}, closed_interval(0, 1)));
  CHECK(rational("sqrt(9/4) + 1") == Rational(5, 2));
  CHECK(rational("sqrt(2)^2") == 2);
  CHECK(refusal("sqrt(-1)") == "column 1: the square root of a negative number is not real");
  CHECK(
      refusal("sqrt(2) + sqrt(3)") ==
      "column 11: square roots of two numbers: such an end is written root(p, a, b), the root of a "
      "polynomial p between a and b");
  CHECK(refusal("1/(√2^2-2)") == "column 1: division by zero");
  CHECK(refusal("1/(sqrt(4)-2)") == "column 1: division by zero");
  CHECK(refusal("1 + sqrt 2") == "column 10: a square root is written sqrt(2)");
  CHECK(refusal("sqrt(2") == "column 5: this \"(\" is never closed");
  CHECK(refusal("sqrt(2)x") ==
        "column 8: no operator between \"√(…)\" and \"x\": a product needs its sign, √(…)*x");
  CHECK(refusal("sqrt(sqrt(2))") == "column 6: \"sqrt\": only rational functions are known");
  CHECK(refusal("sqrt(2)*pi") == "column 9: pi and a square root in one end are not supported");
}

TEST_CASE("endpoints: a rational function of pi is transcendental, or rational") {
  const auto of_pi = [](std::string_view text) {
    return std::get<PiValue>(parse_endpoint(text)).of_pi;
  };
  CHECK(of_pi("pi") == RationalFunction(Polynomial{0, 1}));
  CHECK(of_pi("-2*π/3 + 1") == RationalFunction(Polynomial{1, Rational(-2, 3)}));
  CHECK(of_pi("pi + 2*π") == RationalFunction(Polynomial{0, 3}));
  CHECK(of_pi("1/pi^2") == RationalFunction({1}, {0, 0, 1}));
  CHECK(rational("pi - pi + 1/2") == Rational(1, 2));
  CHECK(refusal("pi*x") == "column 4: \"x\" is not the variable \"π\"");
  CHECK(refusal("1/(sqrt(2) - sqrt(2))") == "column 3: division by zero: \"(√(…) - √(…))\"");
  CHECK(refusal("e") == "column 1: \"e\" is not a rational number");
}

}  // namespace endpoint_test
