#include "phrame/io/write/radical_text.hpp"

#include <doctest/doctest.h>

#include "phrame/algebra/radical_roots.hpp"

using namespace phrame;

namespace {

std::string in_unicode(const Radical& x) { return formatted(x, radical_notation::unicode); }

const Radical i = Radical::imaginary_unit();

Radical root_of(long x) { return sqrt(Radical(x)); }

}  // namespace

TEST_CASE("radical text: numbers and surds over one denominator") {
  CHECK(in_unicode(Radical(0)) == "0");
  CHECK(in_unicode(Rational(-3, 7)) == "−3/7");
  CHECK(in_unicode(root_of(12)) == "2√3");
  CHECK(in_unicode(-root_of(12) / 5) == "−2√3/5");
  CHECK(in_unicode(Rational(-1, 2) + i * root_of(3) / 2) == "(−1 + i√3)/2");
  CHECK(in_unicode(1 - root_of(2)) == "1 − √2");
  CHECK(in_unicode(5 * i) == "5i");
}

TEST_CASE("radical text: nested roots, products and quotients have the parentheses they need") {
  CHECK(in_unicode(sqrt(1 + root_of(2))) == "√(1 + √2)");
  CHECK(in_unicode(cbrt(Radical(2)) * (1 + root_of(2))) == "∛2·(1 + √2)");
  CHECK(in_unicode((1 + root_of(2)) * (1 + root_of(3))) == "(1 + √2)·(1 + √3)");
  CHECK(in_unicode(3 / root_of(2)) == "3/√2");
  CHECK(in_unicode((1 + root_of(3)) / (1 + root_of(2))) == "(1 + √3)/(1 + √2)");
  CHECK(in_unicode((1 + root_of(3)) / (1 + root_of(2)) / 5) == "(1 + √3)/(5(1 + √2))");
  CHECK(in_unicode(-3 * ((1 + root_of(3)) / (1 + root_of(2))) / 5) == "−3(1 + √3)/(5(1 + √2))");
  CHECK(in_unicode(Radical(Rational(-3, 5)) / (1 + root_of(2))) == "−3/(5(1 + √2))");
  CHECK(formatted((1 + root_of(3)) / sqrt(1 + root_of(2)) / 5, radical_notation::latex) ==
        "\\frac{1 + \\sqrt{3}}{5\\sqrt{1 + \\sqrt{2}}}");
  CHECK(in_unicode(3 * (root_of(5) * (1 / root_of(2)))) == "3√5·(1/√2)");
  CHECK(in_unicode(3 * ((1 / root_of(2)) * root_of(5))) == "3(1/√2·√5)");
  CHECK(in_unicode(1 / (root_of(3) * cbrt(Radical(2)))) == "1/(√3·∛2)");
  CHECK(in_unicode(cbrt(Radical(-2))) == "∛(−2)");
}

TEST_CASE("radical text: Cardano's formula in every notation") {
  const Radical x = roots_by_radicals({1, 1, 0, 1})[0];
  CHECK(in_unicode(x) == "(∛(−108 + 12√93) − ∛(108 + 12√93))/6");
  CHECK(formatted(x, radical_notation::latex) ==
        "\\frac{\\sqrt[3]{-108 + 12\\sqrt{93}} - \\sqrt[3]{108 + 12\\sqrt{93}}}{6}");
  CHECK(formatted(x, radical_notation::sympy) ==
        "(cbrt(-108 + 12*sqrt(93)) - cbrt(108 + 12*sqrt(93)))/6");
  CHECK(formatted(x, radical_notation::mathematica) ==
        "((-108 + 12*Sqrt[93])^(1/3) - (108 + 12*Sqrt[93])^(1/3))/6");
  for (const RadicalNotation* notation :
       {&radical_notation::maple, &radical_notation::maxima, &radical_notation::pari})
    CHECK(formatted(x, *notation) == "((-108 + 12*sqrt(93))^(1/3) - (108 + 12*sqrt(93))^(1/3))/6");
}

TEST_CASE("radical text: the imaginary unit and rational numbers as each system reads them") {
  const Radical x = Rational(2, 3) * i * root_of(2);
  CHECK(formatted(x, radical_notation::sympy) == "2*I*sqrt(2)/3");
  CHECK(formatted(x, radical_notation::mathematica) == "2*I*Sqrt[2]/3");
  CHECK(formatted(x, radical_notation::maxima) == "2*%i*sqrt(2)/3");
  CHECK(formatted(x, radical_notation::latex) == "\\frac{2i\\sqrt{2}}{3}");
  CHECK(formatted(Rational(-2, 3), radical_notation::sympy) == "-Rational(2, 3)");
  CHECK(formatted(Rational(-2, 3), radical_notation::pari) == "-(2/3)");
}

TEST_CASE("radical text: as a factor, sums and negative numbers stand in parentheses") {
  CHECK(formatted_factor(1 - root_of(2), radical_notation::unicode) == "(1 − √2)");
  CHECK(formatted_factor(-root_of(2), radical_notation::maple) == "(-sqrt(2))");
  CHECK(formatted_factor((1 - root_of(2)) / 3, radical_notation::unicode) == "(1 − √2)/3");
  CHECK(is_written_negative(-root_of(2)));
  CHECK(is_written_negative(root_of(2) - 1));
  CHECK_FALSE(is_written_negative(1 - root_of(2)));
  CHECK_FALSE(is_written_negative(0));
}
