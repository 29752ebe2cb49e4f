#include "phrame/ph/along/arc_length.hpp"

#include <cmath>

#include "phrame/algebra/error.hpp"
#include "phrame/ph/along/totals.hpp"
#include "phrame/ph/curve/invariants.hpp"
#include "support/curves.hpp"
#include "support/random.hpp"

using namespace phrame;
using test::for_samples;
using test::quintic;
using test::Random;

namespace {

/// A straight line with r′ = f·g² in the direction of x.
Curve line(const Polynomial& g, const Polynomial& f = {1}) { return Curve({g, {}, {}, {}}, f); }

/// A curve whose multiplier does not change sign on [0, 1].
Curve one_way(Random& random, long degree) {
  for (;;) {
    Curve curve = random.curve(degree);
    const Signs signs = multiplier_signs(curve);
    if (!signs.positive || !signs.negative) return curve;
  }
}

/// Is x the double nearest to the t with s(t) = s? Decided by the signs of s(m) − s half way to its
/// neighbours, exactly.
bool is_nearest(const Polynomial& length, const Rational& s, double x) {
  const Rational at = exact_rational(x);
  const Rational low = (at + exact_rational(std::nextafter(x, -1.0))) / 2;
  const Rational high = (at + exact_rational(std::nextafter(x, 2.0))) / 2;
  return (low < 0 || length(low) <= s) && (high > 1 || s <= length(high));
}

}  // namespace

// mpmath, 50 digits: s by quadrature of |r′| from the Bernstein coefficients, t by its root finder.
TEST_CASE("arc length: the quintic of Farouki 2003 has length 71/15; its inverse at four lengths") {
  const ArcLength length(quintic);
  CHECK(length.total() == Rational(71, 15));
  const auto at = [&](const char* s) {
    return round_to_decimal(length.parameter(parse_rational(s)), 30).value;
  };
  CHECK(at("1/5") == "0.0344178812796889441184943119984");
  CHECK(at("1") == "0.188592785000423290809251020539");
  CHECK(at("71/30") == "0.467680000735247043727470424683");
  CHECK(at("3") == "0.601168267899188115519682670797");
  CHECK(length.parameter(0).exact() == 0);
  CHECK(length.parameter(Rational(71, 15)).exact() == 1);
}

TEST_CASE("arc length: the length of a segment on which f changes sign is not ∫fσ") {
  const Polynomial f{-1, 2};
  CHECK(ArcLength(line({1}, f * f)).total() == Rational(1, 3));
  CHECK_THROWS_WITH_AS(ArcLength(line({1}, f)), doctest::Contains("changes sign"), DomainError);
  CHECK(ArcLength(line({1}, {-3})).polynomial() == Polynomial{0, 3});
  CHECK(ArcLength(line({1}, {-3})).parameter(1).exact() == Rational(1, 3));
}

TEST_CASE("arc length: law: it is additive, and the speed is its derivative") {
  for_samples(60, [](Random& random) {
    const Curve curve = one_way(random, 3);
    const ArcLength length(curve);
    CHECK(length.total() == total_length(curve).value.exact());
    CHECK(length.polynomial()(0) == 0);
    const Polynomial speed = differentiate(length.polynomial());
    CHECK(speed * speed == pow(curve.multiplier() * sigma(curve.preimage()), 2));
    // The curve from c on, as a curve of its own: A(c + (1 − c)t), with dt stretched.
    const Rational c(random.integer(0, 9), 10);
    const Polynomial rest{c, 1 - c};
    const auto& [u, v, p, q] = curve.preimage();
    const Curve second({compose(u, rest), compose(v, rest), compose(p, rest), compose(q, rest)},
                       (1 - c) * compose(curve.multiplier(), rest));
    CHECK(ArcLength(second).total() + length.polynomial()(c) == length.total());
  });
}

TEST_CASE("arc length: law: the inverse is the nearest double, proved by signs of s(m) − s") {
  for_samples(200, [](Random& random) {
    const Curve curve = one_way(random, random.chance(10) ? 8 : 3);
    const ArcLength length(curve);
    const Rational s = length.total() * Rational(random.integer(0, 1000), 1000);
    CHECK(is_nearest(length.polynomial(), s, round_to_double(length.parameter(s))));
  });
}

TEST_CASE("arc length: law: a rational parameter comes back exactly") {
  for_samples(100, [](Random& random) {
    const ArcLength length(one_way(random, 3));
    const Rational t = random.chance(4)
                           ? exact_rational(1.0 / static_cast<double>(random.integer(1, 1000)))
                           : Rational(random.integer(0, 360), 360);
    CHECK(length.parameter(length.polynomial()(t)).exact() == t);
    CHECK(length.algebraic_parameter(length.polynomial()(t)).rational() == t);
  });
}

TEST_CASE("arc length: law: the algebraic parameter is the real one, a root of s(t) − s") {
  for_samples(60, [](Random& random) {
    const ArcLength length(one_way(random, 3));
    const Rational s = length.total() * Rational(random.integer(0, 100), 100);
    const RealAlgebraic t = length.algebraic_parameter(s);
    CHECK(sign_at(length.polynomial() - Polynomial{s}, t) == 0);
    CHECK(compare(t, 0) >= 0);
    CHECK(compare(t, 1) <= 0);
    CHECK(enclose(t, 100).overlaps(length.parameter(s).enclose(100)));
  });
}

TEST_CASE("arc length: through cusps: a line that stops at 1/2 has t = (1 + ∛(6s − 1))/2") {
  const ArcLength length(line({-1, 2}));
  CHECK(length.total() == Rational(1, 3));
  CHECK(length.parameter(Rational(1, 6)).exact() == Rational(1, 2));
  CHECK(length.parameter(Rational(3, 16)).exact() == Rational(3, 4));
  // 6s − 1 = 1/2; ∛(1/2) = 0.79370052598409973737585281963615413… (OEIS A270714)
  CHECK(round_to_decimal(length.parameter(Rational(1, 4)), 30).value ==
        "0.896850262992049868687926409818");
  // 6s − 1 = 6·10⁻⁶⁰: t − 1/2 = ∛6·10⁻²⁰/2, ∛6 = 1.8171205928321396588912117563272605…
  CHECK(round_to_decimal(length.parameter(Rational(1, 6) + parse_rational("1e-60")), 40).value ==
        "0.5000000000000000000090856029641606982945");
}

// s = g³ + 1 with g = t³ + t − 1: r′ = f·g² with f = 3g′ > 0, an irrational cusp at the root of g.
TEST_CASE("arc length: an irrational cusp is a triple root, found by bisection or by factors") {
  const Polynomial g{-1, 1, 0, 1};
  const ArcLength length(line(g, Rational(3) * differentiate(g)));
  CHECK(length.total() == 2);
  // OEIS A263719.
  CHECK(round_to_decimal(length.parameter(1), 30).value == "0.682327803828019327369483739711");
  CHECK(length.algebraic_parameter(1).polynomial() == g);
}

TEST_CASE("arc length: lengths off the curve are refused with the value") {
  const ArcLength length(quintic);
  CHECK_THROWS_WITH_AS(length.parameter(5), doctest::Contains("5 is outside [0, 71/15]"),
                       DomainError);
  CHECK_THROWS_WITH_AS(length.parameter(Rational(-1, 10)), doctest::Contains("-1/10 is outside"),
                       DomainError);
  CHECK_THROWS_AS(length.algebraic_parameter(5), DomainError);
}

TEST_CASE("arc length: coefficients beyond the range of doubles only spoil the guess") {
  const Rational huge = pow(Integer(10), 400);
  const ArcLength length(line({1, huge}));  // s = t + 10⁴⁰⁰·t² + 10⁸⁰⁰·t³/3
  const Rational t = parse_rational("1e-390");
  CHECK(length.parameter(length.polynomial()(t)).exact() == t);
  const Rational s = length.total() / 2;
  CHECK(is_nearest(length.polynomial(), s, round_to_double(length.parameter(s))));
}

TEST_CASE("arc length: from a to b it is exact where the sign of f is one between the ends") {
  const Curve turning = line({1}, {1, -2});
  CHECK(arc_length(turning, 0, Rational(1, 2)) == Rational(1, 4));
  CHECK_FALSE(arc_length(turning, 0, 1));
  CHECK(arc_length(turning, Rational(1, 2), 1) == Rational(1, 4));
  CHECK(arc_length(turning, -1, 0) == Rational(2));  // t may be any number
}
