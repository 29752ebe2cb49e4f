#include "phrame/io/write/radical_form_text.hpp"

#include <doctest/doctest.h>

#include "phrame/integrate/integrate.hpp"

using namespace phrame;

namespace {

RadicalForm form(const Polynomial& n, const Polynomial& d) {
  return radical_form(integrate({n, d}));
}

}  // namespace

TEST_CASE("radical form text: rational and quadratic poles are written out") {
  CHECK(to_text(RadicalForm{}) == "0");
  CHECK(to_latex(RadicalForm{}) == "0");
  CHECK(to_text(form({1}, {-2, 0, 1})) == "−√2/4·log|t + √2|\n+ √2/4·log|t − √2|");
  CHECK(to_text(form({3, 1}, {1, 1, 1})) ==
        "(3 − 5i√3)/6·log(t + (1 − i√3)/2)\n+ (3 + 5i√3)/6·log(t + (1 + i√3)/2)");
  CHECK(to_latex(form({1}, {-2, 0, 1})) ==
        "-\\frac{\\sqrt{2}}{4} \\log\\left|t + \\sqrt{2}\\right| + \\frac{\\sqrt{2}}{4} "
        "\\log\\left|t - \\sqrt{2}\\right|");
}

TEST_CASE("radical form text: a positive argument has no bars, any other real one has") {
  CHECK(to_text(form({0, 2}, {1, 0, 1})) == "log(t² + 1)");
  CHECK(to_text(form({-1, 0, 0, 0, 5}, {-1, -1, 0, 0, 0, 1})) == "log|t⁵ − t − 1|");
  CHECK(to_text(form({6, 0, -3, 0, 1}, {4, 0, 5, 0, -5, 0, 1})) ==
        "i/2·log(t³ + it² − 3t − 2i)\n− i/2·log(t³ − it² − 3t + 2i)");
}

TEST_CASE("radical form text: fractions before a power stand in parentheses") {
  const Radical half_i = Radical::imaginary_unit() / 2;
  const LogSum sum{{1, 0, 4}, {0, 1}, Bivariate({Polynomial{1}, Polynomial{0, 1}, Polynomial{1}})};
  const RadicalSum logs{sum, {half_i, -half_i}, {half_i, -half_i}, 0};
  CHECK(to_text({{}, {}, {logs}}) == "i/2·log(t² + (i/2)t + 1)\n− i/2·log(t² − (i/2)t + 1)");
  CHECK(to_cas({logs}, radical_notation::maple) ==
        "I/2*ln(t^2 + I/2*t + 1) - I/2*ln(t^2 - I/2*t + 1)");
}

TEST_CASE("radical form text: polynomial and rational part come first") {
  const RadicalForm F = form({1, 2, 0, 0, 0, 0, 1}, pow(Polynomial{1, 0, 1}, 2) * Polynomial{5, 3});
  CHECK(to_text(F, "x").substr(0, 52).starts_with("(1/6)x² − (5/9)x\n"));
  CHECK(to_text({Polynomial{0, 1}, {{-1}, {0, 1}}, {}}) == "t\n− (1)/(t)");
  CHECK(to_latex({Polynomial{0, 1}, {{-1}, {0, 1}}, {}}) == "t - \\frac{1}{t}");
}

TEST_CASE("radical form text: roots of degree 3 and 4 are listed") {
  CHECK(to_text(form({1}, {-2, 0, 0, 1}), "x") ==
        "Σ c(z)·log(x − z) over the 3 roots z of z³ − 2\n"
        "    c(z) = (1/6)z\n"
        "    z₁ = ∛2   (real, with log|·|)\n"
        "    z₂ = (−∛2 + i√3·∛2)/2\n"
        "    z₃ = (−∛2 − i√3·∛2)/2");
  CHECK(to_latex(form({1}, {-2, 0, 0, 1})) ==
        "\\left(\\frac{1}{6}z_{11}\\right) \\log\\left|t - z_{11}\\right| + "
        "\\sum_{k=2}^{3} \\left(\\frac{1}{6}z_{1k}\\right) \\log\\left(t - z_{1k}\\right),\\quad "
        "z_{11} = \\sqrt[3]{2},\\quad "
        "z_{12} = \\frac{-\\sqrt[3]{2} + i\\sqrt{3} \\sqrt[3]{2}}{2},\\quad "
        "z_{13} = \\frac{-\\sqrt[3]{2} - i\\sqrt{3} \\sqrt[3]{2}}{2}");
}

TEST_CASE("radical form text: the roots have another letter than the variable") {
  CHECK(to_text(form({1}, {-2, 0, 0, 1}), "z", "w")
            .starts_with(
                "Σ c(w)·log(z − w) over the 3 roots w of w³ − 2\n    c(w) = (1/6)w\n    w₁ = ∛2"));
}

TEST_CASE("radical form text: for computer-algebra systems") {
  const auto logs = form({1}, {-2, 0, 1}).logs;
  CHECK(to_cas({}, radical_notation::pari) == "0");
  CHECK(to_cas(logs, radical_notation::sympy) ==
        "-sqrt(2)/4*log(t + sqrt(2)) + sqrt(2)/4*log(t - sqrt(2))");
  CHECK(to_cas(logs, radical_notation::mathematica, "x") ==
        "-Sqrt[2]/4*Log[x + Sqrt[2]] + Sqrt[2]/4*Log[x - Sqrt[2]]");
  CHECK(to_cas(form({6, 0, -3, 0, 1}, {4, 0, 5, 0, -5, 0, 1}).logs, radical_notation::maxima) ==
        "%i/2*log(t^3 + %i*t^2 - 3*t - 2*%i) - %i/2*log(t^3 - %i*t^2 - 3*t + 2*%i)");
}
