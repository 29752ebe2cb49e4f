#include "phrame/io/write/closed_form.hpp"

#include <doctest/doctest.h>

#include <algorithm>

#include "phrame/integrate/integrate.hpp"

namespace closed_form_test {

using namespace phrame;

namespace {

constexpr auto unicode = Notation::unicode;
constexpr auto latex = Notation::latex;

template <class F>
std::string written(const F& f, Notation notation, const Letters& letters = {}) {
  return formatted_sum(formatted_terms(f, notation, letters), " ", notation);
}

std::string written(const ExactValue& x, Notation notation) {
  return formatted_sum(formatted_terms(x, notation), " ", notation);
}

const Integer two = 2;
const Integer three = 3;

}  // namespace

TEST_CASE("closed form: letters of sums are never the variable") {
  for (const char* name : {"t", "x", "z", "y", "w", "theta"}) {
    const Letters letters = letters_for(name, unicode);
    CHECK(letters.variable == name);
    CHECK(letters.pole != name);
    CHECK(letters.residue != name);
    CHECK(letters.pole != letters.residue);
  }
}

TEST_CASE("closed form: LaTeX has the names of Greek letters, and long names in one piece") {
  CHECK(letters_for("t", latex).variable == "t");
  CHECK(letters_for("θ", latex).variable == "\\theta");
  CHECK(letters_for("t_12", latex).variable == "\\mathit{t\\_12}");
}

TEST_CASE("closed form: a quotient has parentheses where they are needed") {
  const auto quotient = [](const Polynomial& n, const Polynomial& d) {
    return formatted_quotient({n, d}, unicode, "x");
  };
  CHECK(quotient({1}, {0, 1}) == "1/x");
  CHECK(quotient({1, 1}, {0, 0, 1}) == "(x + 1)/x²");
  CHECK(quotient({1}, {0, 2}) == "(1/2)/x");
  CHECK(quotient({-2}, {1, 0, 3}) == "−2/(3x² + 1)");
  CHECK(quotient({2, 2}, {1, 0, 1}) == "2(x + 1)/(x² + 1)");
  CHECK(quotient({3, 1}, {1}) == "x + 3");
}

TEST_CASE("closed form: sums over poles and over residues, in the letters given") {
  const Antiderivative poles = integrate({{1}, {1, 0, 1}}, Form::partial_fractions);
  CHECK(written(poles, unicode, letters_for("z", unicode)) ==
        "Σ c(w)·log(z − w) over the 2 roots w of w² + 1\n        c(w) = −(1/2)w");
  CHECK(written(poles, latex, letters_for("z", latex)) ==
        "\\sum_{w^{2} + 1 = 0} \\left(-\\frac{1}{2}w\\right) \\log(z - w)");
  const Antiderivative residues = integrate({{1}, {1, 0, 1}}, Form::rothstein_trager);
  CHECK(written(residues, unicode, letters_for("x", unicode)) ==
        "Σ y·log v(y, x) over the 2 roots y of 4y² + 1\n        v(y, x) = x + (2y)");
}

TEST_CASE("closed form: factors of 1 and −1 are not written") {
  const Antiderivative F = integrate({{1}, {0, -1, 1}});  // log(t − 1) − log t
  CHECK(written(F, unicode) == "−log(t) + log(t − 1)");
  CHECK(written(F, latex) == "-\\log\\left(t\\right) + \\log\\left(t - 1\\right)");
  CHECK(written(Antiderivative{}, unicode) == "0");
}

TEST_CASE("closed form: real functions, with bars only where a logarithm needs them") {
  const RealForm F{{0, 1},
                   {},
                   {{{0, Rational(1, 8), two}, {{1, 0, 1}, {0, 1}, two}, true},
                    {{-1, 0}, {{-1, 1}, {}}, false},
                    {{Rational(1, 2), -1, three}, {{0, 1}, {1}, three}, false}},
                   {{{1, 0}, {{1}, {0, 1}, two}}},
                   {}};
  CHECK(written(F, unicode, letters_for("x", unicode)) ==
        "x + √2/8·log(x² + √2·x + 1) − log|x − 1| + (1/2 − √3)·log|x + √3| + arctan(√2·x + 1)");
  CHECK(written(F, latex, letters_for("x", latex)) ==
        "x + \\frac{\\sqrt{2}}{8} \\log\\left(x^{2} + \\sqrt{2} x + 1\\right) - "
        "\\log\\left|x - 1\\right| + \\left(\\frac{1}{2} - \\sqrt{3}\\right) "
        "\\log\\left|x + \\sqrt{3}\\right| + \\arctan\\left(\\sqrt{2} x + 1\\right)");
}

// √(5 ± √2 ± √3) is no sum of square roots. The integral of n/(x² + h) is
// n/√h·arctan(x/√h).
TEST_CASE("closed form: roots of numbers with several roots are divided by") {
  const Surd h = Surd(5) + Surd{0, 1, 2} + Surd{0, 1, 3};
  const RealForm F{
      {},
      {},
      {},
      {{(Surd(2) + Surd{0, 1, 2} + Surd{0, 1, 3}) / h, surd_polynomial({Surd(0), Surd(1) / h}), h}},
      {},
      {{Rational(-1, 3) * (Surd(2) + Surd{0, 1, 3} - Surd{0, 1, 2}) / h,
        surd_polynomial({Surd(1), Surd(1)}), h}}};
  const std::string root = "√(5 + √3 + √2)";
  CHECK(written(F, unicode, letters_for("x", unicode)) ==
        "−(2 + √3 − √2)/(3" + root + ")·log|(x + 1 − " + root + ")/(x + 1 + " + root +
            ")| + (2 + √3 + √2)/" + root + "·arctan(x/" + root + ")");
  CHECK(written(F, latex, letters_for("x", latex))
            .find("-\\frac{2 + \\sqrt{3} - \\sqrt{2}}{3\\sqrt{5 + ") != std::string::npos);
}

// t⁴ − 2 has two real roots and one with a positive imaginary part.
TEST_CASE("closed form: what is left of a real form is a sum over real and over upper poles") {
  const RealForm F{
      {}, {}, {}, {}, {{{-2, 0, 0, 0, 1}, {0, Rational(1, 8)}, Bivariate({{0, -1}, {1}})}}};
  const std::vector<std::string> terms = formatted_terms(F, unicode);
  REQUIRE(terms.size() == 2);
  CHECK(terms[0] == "Σ c(z)·log|t − z| over the 2 real roots z of z⁴ − 2\n        c(z) = (1/8)z");
  CHECK(terms[1] ==
        "Σ (Re c(z)·log|t − z|² − 2·Im c(z)·arctan((t − Re z)/Im z))\n"
        "        over the root z of z⁴ − 2 with Im z > 0\n        c(z) = (1/8)z");
  const std::string text = written(F, latex);
  CHECK(std::count(text.begin(), text.end(), '{') == std::count(text.begin(), text.end(), '}'));
}

TEST_CASE("closed form: exact values") {
  CHECK(written(ExactValue{}, unicode) == "0");
  const ExactValue x{
      Rational(-1, 3), Rational(-1, 4), {{1, 5}, {Rational(1, 2), Rational(3, 2)}}, {{-1, 2}}};
  CHECK(written(x, unicode) == "−1/3 − π/4 + log(5) + 1/2·log(3/2) − arctan(2)");
  CHECK(written({0, 3, {}, {}}, unicode) == "3π");
  CHECK(written({0, Rational(3, 2), {}, {}}, latex) == "\\frac{3\\pi }{2}");
}

}  // namespace closed_form_test
