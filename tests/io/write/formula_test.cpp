#include "phrame/io/write/formula.hpp"

#include <doctest/doctest.h>

namespace formula_test {

using namespace phrame;

namespace {

constexpr auto unicode = Notation::unicode;
constexpr auto latex = Notation::latex;

std::string plain(const Polynomial& p) { return formatted(p, unicode); }
std::string factored(const Polynomial& p) { return formatted_factors(p, unicode); }

}  // namespace

TEST_CASE("formula: numbers have a true minus sign in Unicode and a fraction in LaTeX") {
  CHECK(formatted(Rational(-3, 7), unicode) == "−3/7");
  CHECK(formatted(Rational(-3, 7), latex) == "-\\frac{3}{7}");
  CHECK(formatted(Rational(-2), latex) == "-2");
  CHECK(formatted(Rational(0), unicode) == "0");
}

TEST_CASE("formula: polynomials are written as by hand, highest power first") {
  CHECK(plain({6, -12, 46, -72, 37}) == "37t⁴ − 72t³ + 46t² − 12t + 6");
  CHECK(plain({}) == "0");
  CHECK(plain({-5}) == "−5");
  CHECK(plain({Rational(1, 2)}) == "1/2");
  CHECK(plain({0, 1}) == "t");
  CHECK(plain({0, -1}) == "−t");
  CHECK(plain({1, 0, -1}) == "−t² + 1");
  CHECK(plain({0, Rational(-1, 3), Rational(2, 5)}) == "(2/5)t² − (1/3)t");
  CHECK(plain(Polynomial::monomial(3, 120)) == "3t¹²⁰");
  CHECK(formatted(Polynomial{1, 1}, unicode, "x") == "x + 1");
}

TEST_CASE("formula: polynomials in LaTeX have braces around exponents and no parentheses") {
  CHECK(formatted(Polynomial{-1, Rational(1, 2), 0, 4}, latex) == "4t^{3} + \\frac{1}{2}t - 1");
  CHECK(formatted(Polynomial::monomial(-1, 12), latex, "z") == "-z^{12}");
  CHECK(formatted(Polynomial(), latex) == "0");
}

TEST_CASE("formula: factors stand in parentheses, a bare t does not") {
  CHECK(factored({0, -4, 4}) == "4t(t − 1)");
  CHECK(factored({1, 2, 1}) == "(t + 1)²");
  CHECK(factored({-1, -2, -1}) == "−(t + 1)²");
  CHECK(factored({0, 0, 0, 2}) == "2t³");
  CHECK(factored({2, 0, 2}) == "2(t² + 1)");
  CHECK(factored({Rational(-1, 2), 0, Rational(1, 2)}) == "(1/2)(t − 1)(t + 1)");
  CHECK(formatted_factors(Polynomial{Rational(1, 2), 0, Rational(1, 2)}, latex) ==
        "\\frac{1}{2}(t^{2} + 1)");
}

TEST_CASE("formula: what has no factors is written as it is") {
  CHECK(factored({}) == "0");
  CHECK(factored({-7}) == "−7");
  CHECK(factored({0, 1}) == "t");
  CHECK(factored({1, 0, 1}) == "t² + 1");
}

TEST_CASE("formula: Gaussian polynomials show only the parts they have") {
  const auto g = [](const Polynomial& re, const Polynomial& im) {
    return formatted(GaussianPolynomial{re, im}, unicode);
  };
  CHECK(g({12, -24, 4}, {-6, 14, 2}) == "(4t² − 24t + 12) + (2t² + 14t − 6)i");
  CHECK(g({1, 1}, {}) == "t + 1");
  CHECK(g({}, {1}) == "i");
  CHECK(g({}, {0, 2}) == "(2t)i");
  CHECK(g({0, 0, 1}, {1}) == "(t²) + i");
  CHECK(g({}, {}) == "0");
}

TEST_CASE("formula: bivariate polynomials put only coefficients with an x into parentheses") {
  const Bivariate v({Polynomial{1, 2}, Polynomial{-1}, Polynomial{}, Polynomial{0, 1}, {1}});
  CHECK(formatted(v, unicode) == "t⁴ + (x)t³ − t + (2x + 1)");
  CHECK(formatted(v, latex) == "t^{4} + \\left(x\\right)t^{3} - t + \\left(2x + 1\\right)");
  CHECK(formatted(Bivariate({Polynomial{Rational(-1, 2)}, {}, {1}}), unicode) == "t² − 1/2");
  CHECK(formatted(Bivariate({Polynomial{}, {Rational(-1, 2)}}), unicode) == "−(1/2)t");
  CHECK(formatted(Bivariate(), unicode) == "0");
}

TEST_CASE("formula: surds") {
  const auto written = [](const Surd& x) { return formatted(x, Notation::unicode); };
  CHECK(written({Rational(-3, 2), 0}) == "−3/2");
  CHECK(written({0, 1, 2}) == "√2");
  CHECK(written({0, Rational(-3, 8), 2}) == "−3√2/8");
  CHECK(written({Rational(1, 2), -1, 3}) == "1/2 − √3");
  CHECK(formatted(Surd{1, Rational(-3, 8), 2}, Notation::latex) == "1 - \\frac{3\\sqrt{2}}{8}");
  // Several roots: the greatest first, over one denominator.
  const Surd difference = Surd{0, 1, 6} - Surd{0, 1, 2};
  CHECK(written(difference) == "√6 − √2");
  CHECK(written(-difference) == "−√6 + √2");
  CHECK(written(Surd(5) + Rational(-1, 2) * difference) == "(10 − √6 + √2)/2");
  CHECK(written(Rational(-1, 2) * difference) == "−(√6 − √2)/2");
  CHECK(formatted(Rational(1, 2) * difference, Notation::latex) ==
        "\\frac{\\sqrt{6} - \\sqrt{2}}{2}");
}

TEST_CASE("formula: polynomials with surds, highest power first") {
  const auto written = [](const SurdPolynomial& p) { return formatted(p, Notation::unicode, "x"); };
  CHECK(written({{}, {}}) == "0");
  CHECK(written({{1, 2}, {}}) == "2x + 1");
  CHECK(written({{1, 0, 1}, {0, -1}, 2}) == "x² − √2·x + 1");
  CHECK(written({{1, 2}, {Rational(-1, 2), 3}, 5}) == "(2 + 3√5)·x + 1 − √5/2");
  CHECK(written({{}, {0, 0, Rational(1, 3)}, 7}) == "√7/3·x²");
  CHECK(formatted(SurdPolynomial{{0, 1}, {0, 1}, 2}, Notation::latex) ==
        "\\left(1 + \\sqrt{2}\\right) t");
  const Surd sum = Surd{0, 1, 2} + Surd{0, 1, 3};
  CHECK(written(surd_polynomial({sum, sum, Surd(1)})) == "x² + (√3 + √2)·x + √3 + √2");
  CHECK(written(surd_polynomial({-sum, Rational(-1, 2) * sum, Surd(1)})) ==
        "x² − (√3 + √2)/2·x − √3 − √2");
  CHECK(written(surd_polynomial({Rational(-1, 2) * sum, Surd{0, 1, 3}, Surd{0, 1, 2}})) ==
        "√2·x² + √3·x − (√3 + √2)/2");
  CHECK(formatted(surd_polynomial({Surd(0), Rational(-1, 2) * sum}), Notation::latex) ==
        "-\\frac{\\sqrt{3} + \\sqrt{2}}{2} t");
}

}  // namespace formula_test
