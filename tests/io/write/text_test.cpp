#include "phrame/io/write/text.hpp"

#include <doctest/doctest.h>

using namespace phrame;

namespace {

constexpr auto unicode = Notation::unicode;
constexpr auto latex = Notation::latex;

std::string plain(const Polynomial& p) { return formatted(p, unicode); }
std::string factored(const Polynomial& p) { return formatted_factors(p, unicode); }

}  // namespace

TEST_CASE("text: numbers have a true minus sign in Unicode and a fraction in LaTeX") {
  CHECK(formatted(Rational(-3, 7), unicode) == "−3/7");
  CHECK(formatted(Rational(-3, 7), latex) == "-\\frac{3}{7}");
  CHECK(formatted(Rational(-2), latex) == "-2");
  CHECK(formatted(Rational(0), unicode) == "0");
}

TEST_CASE("text: polynomials are written as by hand, highest power first") {
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

TEST_CASE("text: polynomials in LaTeX have braces around exponents and no parentheses") {
  CHECK(formatted(Polynomial{-1, Rational(1, 2), 0, 4}, latex) == "4t^{3} + \\frac{1}{2}t - 1");
  CHECK(formatted(Polynomial::monomial(-1, 12), latex, "z") == "-z^{12}");
  CHECK(formatted(Polynomial(), latex) == "0");
}

TEST_CASE("text: factors stand in parentheses, a bare t does not") {
  CHECK(factored({0, -4, 4}) == "4t(t − 1)");
  CHECK(factored({1, 2, 1}) == "(t + 1)²");
  CHECK(factored({-1, -2, -1}) == "−(t + 1)²");
  CHECK(factored({0, 0, 0, 2}) == "2t³");
  CHECK(factored({2, 0, 2}) == "2(t² + 1)");
  CHECK(factored({Rational(-1, 2), 0, Rational(1, 2)}) == "(1/2)(t − 1)(t + 1)");
  CHECK(formatted_factors(Polynomial{Rational(1, 2), 0, Rational(1, 2)}, latex) ==
        "\\frac{1}{2}(t^{2} + 1)");
}

TEST_CASE("text: what has no factors is written as it is") {
  CHECK(factored({}) == "0");
  CHECK(factored({-7}) == "−7");
  CHECK(factored({0, 1}) == "t");
  CHECK(factored({1, 0, 1}) == "t² + 1");
}

TEST_CASE("text: Gaussian polynomials show only the parts they have") {
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

TEST_CASE("text: bivariate polynomials put only coefficients with an x into parentheses") {
  const Bivariate v({Polynomial{1, 2}, Polynomial{-1}, Polynomial{}, Polynomial{0, 1}, {1}});
  CHECK(formatted(v, unicode) == "t⁴ + (x)t³ − t + (2x + 1)");
  CHECK(formatted(v, latex) == "t^{4} + \\left(x\\right)t^{3} - t + \\left(2x + 1\\right)");
  CHECK(formatted(Bivariate({Polynomial{Rational(-1, 2)}, {}, {1}}), unicode) == "t² − 1/2");
  CHECK(formatted(Bivariate({Polynomial{}, {Rational(-1, 2)}}), unicode) == "−(1/2)t");
  CHECK(formatted(Bivariate(), unicode) == "0");
  CHECK(readable(v) == formatted(v, unicode));
  CHECK(abridged(readable(Bivariate({Polynomial{0, parse_rational("1e250")}, {1}}))) ==
        "⟨degree 1 in t⟩");
}

TEST_CASE("text: control characters, in one byte or two, are escaped; other characters stay") {
  CHECK(printable("a\x1b[31m\nb\x7f") == "a\\u001b[31m\\u000ab\\u007f");
  CHECK(printable("\xC2\x9B"
                  "31m\xC2\x80") == "\\u009b31m\\u0080");
  CHECK(printable("σ é \xC2\xA0 ⟨⟩ \xC2") == "σ é \xC2\xA0 ⟨⟩ \xC2");
  CHECK(printable("") == "");
}

TEST_CASE("text: the width counts characters, not bytes") {
  CHECK(text_width("") == 0);
  CHECK(text_width("abc") == 3);
  CHECK(text_width("−2t²") == 4);  // 3 + 1 + 1 + 2 bytes
  CHECK(text_width("⟨σ⟩") == 3);
}

TEST_CASE("text: what no screen line can bear is replaced by its degree and its digits") {
  const Polynomial p{parse_rational("12345/678"), 1};  // in lowest terms 4115/226
  CHECK(readable("short", p) == "short");
  CHECK(readable(std::string(240, 'x'), p) == std::string(240, 'x'));
  CHECK(abridged(readable(std::string(241, 'x'), p)) ==
        "⟨degree 1, coefficients of up to 4 digits⟩");
  CHECK(for_reading(readable(std::string(241, 'x'), p), true) == std::string(241, 'x'));
  // Of a Gaussian polynomial the higher degree and the longer coefficient, not those of its norm.
  const GaussianPolynomial g{Polynomial::monomial(parse_rational("1e250"), 3), Polynomial{1}};
  CHECK(abridged(readable(g)) == "⟨degree 3, coefficients of up to 251 digits⟩");
  CHECK(abridged(readable({Polynomial{1}, Polynomial::monomial(parse_rational("1e250"), 3)})) ==
        abridged(readable(g)));
  CHECK(readable({Polynomial{1}, Polynomial{0, 1}}) == "1 + (t)i");
  const Polynomial q{-parse_rational("1e53")};  // 54 digits; the sign is none
  CHECK(abridged(readable(std::string(300, 'x'), q)) ==
        "⟨degree 0, coefficients of up to 54 digits⟩");
}

TEST_CASE("text: a passage is read in full or abridged, and that it is abridged is said") {
  const std::string text = "a " + passage("long", "l…") + " b " + passage("", "⟨c⟩") + "\n";
  CHECK(for_reading(text, true) == "a long b \n");
  CHECK(abridged(text) == "a l… b ⟨c⟩\n");
  CHECK(for_reading(text, false) ==
        abridged(text) + "\nLong parts are abridged (--full prints it all).\n");
  CHECK(for_reading("a\n", false) == "a\n");
  CHECK(text_width(text) == 11);
  // A passage within a longer one becomes part of it.
  const std::string nested = readable_exact("a " + passage(std::string(90, 'b'), "b…") + " c", 50);
  CHECK(nested == "a " + passage(std::string(90, 'b'), "b…") + " c");
  const std::string outer = readable_exact(std::string(60, 'a') + passage("bbb", "b…"), 50);
  CHECK(for_reading(outer, true) == std::string(60, 'a') + "bbb");
  CHECK(abridged(outer) == abbreviated(std::string(60, 'a') + "b…", 50));
  CHECK(printable(abridged(outer)) == abridged(outer));
  const auto column = aligned({"t", passage("123456", "12…"), "5678"});
  CHECK(for_reading(column[0], true) == "t     ");
  CHECK(abridged(column[0]) == "t   ");
  CHECK(abridged(column[1]) == "12… ");
  CHECK(for_reading(column[2], true) == "5678  ");
}

// 123456789012345678901/7 = 17636684144620811271.5714…; 1/3·10⁻²⁰ = 3.333…·10⁻²¹.
TEST_CASE("text: a decimal stands beside a fraction of more than 20 digits") {
  CHECK(shown(parse_rational("12345678901234567890/7")) == "12345678901234567890/7");
  CHECK(shown(parse_rational("123456789012345678901/7")) ==
        "123456789012345678901/7 ≈ 1.76366841446e19");
  CHECK(shown(parse_rational("-1/300000000000000000000")) ==
        "−1/300000000000000000000 ≈ -3.33333333333e-21");
  CHECK(shown(parse_rational("1e-25")) == "1/10000000000000000000000000 = 1.00000000000e-25");
  CHECK(shown(parse_rational("123456789012345678901234567890")) ==
        "123456789012345678901234567890");  // no fraction
  const Rational tiny = parse_rational("1e-500");
  CHECK(abridged(shown(tiny)).ends_with("… (503 characters) = 1.00000000000e-500"));
  const Real x(parse_rational("1/300000000000000000000"));
  CHECK(shown(x, round_to_decimal(x, 3)) == "1/300000000000000000000 ≈ 3.33e-21");
}

TEST_CASE("text: surds") {
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

TEST_CASE("text: polynomials with surds, highest power first") {
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

TEST_CASE("text: one is singular, none and many are plural") {
  CHECK(counted(0, "digit") == "0 digits");
  CHECK(counted(1, "digit") == "1 digit");
  CHECK(counted(2, "digit") == "2 digits");
}
