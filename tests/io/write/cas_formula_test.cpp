#include "phrame/io/write/cas_formula.hpp"

#include <doctest/doctest.h>

#include <cmath>

#include "phrame/integrate/integrate.hpp"
#include "phrame/io/read/expression.hpp"
#include "support/random.hpp"

using namespace phrame;
using test::for_samples;
using test::Random;

// That the systems read all this, and find the derivative right, is tried in tests/peers.

namespace {

constexpr Language languages[] = {Language::plain, Language::sympy,  Language::mathematica,
                                  Language::maple, Language::maxima, Language::pari};

const Antiderivative& over_poles() {
  static const Antiderivative F = integrate({{1}, {1, 1, 0, 0, 1}}, Form::partial_fractions);
  return F;
}

}  // namespace

TEST_CASE("cas formula: a variable that means something somewhere becomes x") {
  CHECK(cas_variable("t") == "t");
  CHECK(cas_variable("z") == "z");
  for (const char* name : {"I", "E", "θ", "t1", "lambda", "theta", ""})
    CHECK(cas_variable(name) == "x");
}

TEST_CASE("cas formula: what is written plainly is read back") {
  for (const RationalFunction& f :
       {RationalFunction(), RationalFunction({1}, {0, 1}),
        RationalFunction({Rational(-1, 2), 0, Rational(3, 7)}, {1, -1, 0, 5}),
        RationalFunction(Polynomial{0, -1, 1}), RationalFunction(Polynomial{Rational(-2, 3)})})
    CHECK(parse_expression(cas_formula(f, Language::plain, "x"), "x").value == f);
}

TEST_CASE("cas formula: no fraction is left to integer division or to precedence") {
  const RationalFunction f({0, Rational(-3, 2)}, {1, 0, 2});
  CHECK(cas_formula(f, Language::sympy, "x") == "(-Rational(3, 2)*x)/(2*x**2 + 1)");
  for (const Language language :
       {Language::mathematica, Language::maple, Language::maxima, Language::pari})
    CHECK(cas_formula(f, language, "x") == "-(3/2)*x/(2*x^2 + 1)");
}

TEST_CASE("cas formula: a sum over roots in each language") {
  const Antiderivative F{{}, {}, {{{1, 0, 0, 1}, {0, 2}, Bivariate({{0, -1}, {1}})}}};
  const auto written = [&](Language language) { return cas_formula(F, language, "x"); };
  CHECK(written(Language::sympy) ==
        "RootSum(Poly(z**3 + 1, z), Lambda(z, 2*z*log(x - z)), auto=False)");
  CHECK(written(Language::mathematica) == "RootSum[#^3 + 1 &, 2*#*Log[x - #] &]");
  CHECK(written(Language::maple) == "sum(2*_R*ln(x - _R), _R = RootOf(_Z^3 + 1))");
  CHECK(written(Language::maxima) == "lsum(2*z*log(x - z), z, rootsof(z^3 + 1, z))");
  CHECK(written(Language::pari) == "vecsum([2*z*log(x - z) | z <- polroots('z^3 + 1)])");
}

TEST_CASE("cas formula: an argument is divided by its leading coefficient, to be x − z again") {
  const Antiderivative F{{}, {}, {{{1, 0, 0, 1}, {0, 1}, Bivariate({{5, -1}, {0, 0, 3}})}}};
  CHECK(cas_formula(F, Language::pari, "x") ==
        "vecsum([z*log((3*z^2*x + (-z + 5))/(3*z^2)) | z <- polroots('z^3 + 1)])");
  CHECK(cas_formula(F, Language::mathematica, "x") ==
        "RootSum[#^3 + 1 &, #*Log[(3*#^2*x + (-# + 5))/(3*#^2)] &]");
}

TEST_CASE("cas formula: the letter of a sum is not the variable") {
  CHECK(cas_formula(over_poles(), Language::sympy, "z").find("Lambda(w, ") != std::string::npos);
  CHECK(cas_formula(over_poles(), Language::sympy, "w").find("Lambda(z, ") != std::string::npos);
}

TEST_CASE("cas formula: the sum over one root is its term") {
  const Antiderivative F = integrate({{1}, {0, -1, 1}}, Form::partial_fractions);
  for (const Language language : {Language::sympy, Language::maxima, Language::pari})
    CHECK(cas_formula(F, language, "x") == "-log(x) + log(x - 1)");
  CHECK(cas_formula(Antiderivative{}, Language::maple, "x") == "0");
}

TEST_CASE("cas formula: real functions and surds in each language") {
  const RealForm F{
      {0, 1},
      {{1}, {0, 1}},
      {{{0, Rational(-1, 8), 2}, {{1, 0, 1}, {0, 1}, 2}, true}, {{-1, 0}, {{-1, 1}, {}}, false}},
      {{{1, 0}, {{0, 1}, {-1}, 3}}},
      {}};
  CHECK(cas_formula(F, Language::sympy, "x") ==
        "x + 1/(x) - Rational(1, 8)*sqrt(2)*log(x**2 + sqrt(2)*x + 1) - log(Abs(x - 1)) + "
        "atan(x - sqrt(3))");
  CHECK(cas_formula(F, Language::mathematica, "x") ==
        "x + 1/(x) - (1/8)*Sqrt[2]*Log[x^2 + Sqrt[2]*x + 1] - Log[Abs[x - 1]] + "
        "ArcTan[x - Sqrt[3]]");
}

TEST_CASE("cas formula: numbers with several roots") {
  const Surd sum = Rational(1, 2) * (Surd{0, 1, 6} + Surd{0, 1, 2});
  const RealForm F{{},
                   {},
                   {{-sum, surd_polynomial({Surd(1), -sum, Surd(1)}), true}},
                   {{Surd(1), surd_polynomial({Surd(0), Surd(1)}), sum * sum}}};
  CHECK(cas_formula(F, Language::pari, "x") ==
        "(-(1/2)*sqrt(2) - (1/2)*sqrt(6))*log(x^2 - (1/2)*sqrt(2)*x - (1/2)*sqrt(6)*x + 1) + "
        "(sqrt(6) + sqrt(2))/2*atan((sqrt(6) + sqrt(2))/2*x)");
}

TEST_CASE("cas formula: what is left of a real form is real in PARI") {
  const RealForm F{{}, {}, {}, {}, over_poles().logs};
  CHECK(cas_formula(F, Language::pari, "x").starts_with("real(vecsum(["));
  CHECK(cas_formula(F, Language::maple, "x") == cas_formula(over_poles(), Language::maple, "x"));
}

TEST_CASE("cas formula: exact values and decimals") {
  const ExactValue x{Rational(-1, 3), Rational(-1, 4), {{1, 5}}, {{-2, Rational(1, 2)}}};
  CHECK(cas_formula(x, Language::plain) == "-1/3 - 1/4*pi + log(5) - 2*atan(1/2)");
  CHECK(cas_formula(x, Language::maxima) == "-(1/3) - (1/4)*%pi + log(5) - 2*atan((1/2))");
  CHECK(cas_formula(x, Language::sympy) ==
        "-Rational(1, 3) - Rational(1, 4)*pi + log(5) - 2*atan(Rational(1, 2))");
  for (const Language language : languages) CHECK(cas_formula(ExactValue{}, language) == "0");
  const Decimal d{"-1.50e-12", "5e-15"};
  CHECK(cas_formula(d, Language::sympy) == "Float('-1.50e-12', 3)");
  CHECK(cas_formula(d, Language::mathematica) == "-1.50`2*^-12");
  CHECK(cas_formula(d, Language::maxima) == "-1.50b-12");
  CHECK(cas_formula(d, Language::pari) == "-1.50e-12");
  // Zeros in front are no significant digits.
  CHECK(cas_formula(Decimal{"0.0131", "5e-5"}, Language::sympy) == "Float('0.0131', 3)");
  CHECK(cas_formula(Decimal{"0.0131", "5e-5"}, Language::mathematica) == "0.0131`2");
  CHECK(cas_formula(Decimal{"-0.50", "5e-3"}, Language::mathematica) == "-0.50`2");
  CHECK(cas_formula(Decimal{"4", "0.5"}, Language::mathematica) == "4`0.3");
  CHECK(cas_formula(Decimal{"0", "0"}, Language::mathematica) == "0");
  const std::string nines(5000, '9');
  CHECK(cas_formula(Decimal{"-0.0" + nines, "1"}, Language::sympy) ==
        "Float(Rational(-" + nines + "*10**0, 10**5001), 5000)");
  CHECK(cas_formula(Decimal{"9." + nines + "e6000", "1"}, Language::sympy) ==
        "Float(Rational(9" + nines + "*10**1000, 10**0), 5001)");
}

// The interval that x`p stands for, |x|·10⁻ᵖ on both sides, holds all numbers that round to x.
TEST_CASE("cas formula: law: the precision in Mathematica's numbers is no larger than it is") {
  for_samples(200, [](Random& random) {
    const long n = random.integer(1, 6);
    const Decimal d = round_to_decimal(Rational(random.integer(1, 999'999), 1'000'003), n);
    const std::string text = cas_formula(d, Language::mathematica);
    CAPTURE(text);
    const auto tick = text.find('`');
    const double precision = std::stod(text.substr(tick + 1, text.find('*') - tick - 1));
    const auto value = parse_rational(text.substr(0, tick));
    const Rational half_unit = Rational(1, 2) * power_of_ten(decimal_exponent(value) + 1 - n);
    CHECK(value * exact_rational(std::pow(10.0, -precision)) >= half_unit * Rational(999, 1000));
  });
}
