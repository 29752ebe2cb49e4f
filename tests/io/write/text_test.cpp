#include "phrame/io/write/text.hpp"

#include <doctest/doctest.h>

#include "phrame/algebra/real_algebraic.hpp"
#include "phrame/algebra/sturm.hpp"

using namespace phrame;

TEST_CASE("text: control characters, in one byte or two, are escaped; other characters stay") {
  CHECK(printable("a\x1b[31m\nb\x7f") == "a\\u001b[31m\\u000ab\\u007f");
  CHECK(printable("\xC2\x9B"
                  "31m\xC2\x80") == "\\u009b31m\\u0080");
  CHECK(printable("σ é \xC2\xA0 ⟨⟩ 𝕜") == "σ é \xC2\xA0 ⟨⟩ 𝕜");
  // What is no UTF-8: lone bytes, a longer form of "/", half of a surrogate pair, beyond U+10FFFF.
  CHECK(printable("\xFF{\xE9\xC2") == "\\xff{\\xe9\\xc2");
  CHECK(printable("\xC0\xAF\xE0\x80\xAF") == "\\xc0\\xaf\\xe0\\x80\\xaf");
  CHECK(printable("\xED\xA0\x80\xF4\x90\x80\x80") == "\\xed\\xa0\\x80\\xf4\\x90\\x80\\x80");
  CHECK(printable("") == "");
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

TEST_CASE("text: a bivariate polynomial that is too long is replaced by its degree") {
  const Bivariate v({Polynomial{1, 2}, Polynomial{-1}, Polynomial{}, Polynomial{0, 1}, {1}});
  CHECK(readable(v) == formatted(v, Notation::unicode));
  CHECK(abridged(readable(Bivariate({Polynomial{0, parse_rational("1e250")}, {1}}))) ==
        "⟨degree 1 in t⟩");
}

TEST_CASE("text: a passage within a longer one becomes part of it; columns are equally wide") {
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
        "−1/300000000000000000000 ≈ −3.33333333333e-21");
  CHECK(shown(parse_rational("1e-25")) == "1/10000000000000000000000000 = 1.00000000000e-25");
  CHECK(shown(parse_rational("123456789012345678901234567890")) ==
        "123456789012345678901234567890");  // no fraction
  const Rational tiny = parse_rational("1e-500");
  CHECK(abridged(shown(tiny)) == "1/10000000…00000000 (1/501 digits) = 1.00000000000e-500");
  CHECK(for_reading(shown(tiny), true) == "1/1" + std::string(500, '0') + " = 1.00000000000e-500");
  CHECK(abridged(shown(-(1 / tiny) - 7)) == "−10000000…00000007 (501 digits)");
  const Real x(parse_rational("1/300000000000000000000"));
  CHECK(shown(x, round_to_decimal(x, 3)) == "1/300000000000000000000 ≈ 3.33e-21");
}

TEST_CASE("text: irrational numbers of either sign are cut off") {
  const auto roots =
      real_roots(Polynomial{-5, 0, 1}, closed_interval(-3, 3));  // 2.2360679774997896…
  REQUIRE(roots.size() == 2);
  CHECK(shown(roots[0].at) == "−2.23606797749…");
  CHECK(shown(roots[1].at) == "2.23606797749…");
}

TEST_CASE("text: one is singular, none and many are plural") {
  CHECK(counted(0, "digit") == "0 digits");
  CHECK(counted(1, "digit") == "1 digit");
  CHECK(counted(2, "digit") == "2 digits");
}

TEST_CASE("text: three numbers and more that follow each other are a range") {
  CHECK(ranges({}).empty());
  CHECK(ranges({7}) == "7");
  CHECK(ranges({1, 2, 4}) == "1, 2, 4");
  CHECK(ranges({1, 2, 3, 5, 7, 8, 9, 10}) == "1 to 3, 5, 7 to 10");
}
