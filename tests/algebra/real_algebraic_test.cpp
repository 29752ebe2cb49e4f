#include <algorithm>

#include "phrame/algebra/real_algebraic.hpp"

#include "phrame/algebra/error.hpp"
#include "phrame/algebra/factor.hpp"
#include "support/random.hpp"

namespace real_algebraic_test {

using namespace phrame;
using test::for_samples;
using test::Random;

namespace {

RealAlgebraic root_of(const Rational& square) {
  return real_root(Polynomial{-square, 0, 1}, {Rational(0), std::nullopt});
}

bool has_accurate_ball(const RealAlgebraic& a, long bits) {
  const RealBall ball = enclose(a, bits);
  return ball.is_accurate(bits) && compare(a, ball.lower()) >= 0 && compare(a, ball.upper()) <= 0;
}

}  // namespace

TEST_CASE("real algebraic: the square root of 2") {
  const RealAlgebraic root = real_root({-2, 0, 1}, closed_interval(1, 2));
  CHECK(root.polynomial() == Polynomial{-2, 0, 1});
  CHECK_FALSE(root.is_rational());
  CHECK(compare(root, Rational(1414213562, 1000000000)) > 0);
  CHECK(compare(root, Rational(1414213563, 1000000000)) < 0);
  CHECK(compare(root, -7) > 0);
  CHECK(compare(root, 7) < 0);
  // OEIS A002193.
  CHECK(round_to_decimal(to_real(root), 50).value ==
        "1.4142135623730950488016887242096980785696718753769");
}

TEST_CASE("real algebraic: a rational root of a reducible polynomial is exact") {
  // (3t − 1)(t² − 2)²
  const Polynomial p = Polynomial{-1, 3} * pow(Polynomial{-2, 0, 1}, 2);
  const RealAlgebraic third = real_root(p, closed_interval(0, 1));
  CHECK(third.rational() == Rational(1, 3));
  CHECK(third.polynomial() == Polynomial{-1, 3});
  CHECK(third.interval() == closed_interval(Rational(1, 3), Rational(1, 3)));
  CHECK(third == RealAlgebraic(Rational(1, 3)));
  CHECK(real_root(p, {Rational(1, 3), Rational(2), false, true}) == root_of(2));
  CHECK(RealAlgebraic() == RealAlgebraic(Rational(0)));
}

TEST_CASE("real algebraic: no root or several roots are refused with their number") {
  CHECK_THROWS_WITH_AS(real_root({1, 0, 1}, real_line()),
                       "real_root: no real roots in (−∞, ∞), not one", DomainError);
  CHECK_THROWS_WITH_AS(real_root({-2, 0, 1}, closed_interval(-2, 2)),
                       "real_root: 2 real roots in [-2, 2], not one", DomainError);
  // Of two different factors.
  CHECK_THROWS_WITH_AS(
      real_root(Polynomial{-2, 0, 1} * Polynomial{-3, 0, 1}, closed_interval(1, 2)),
      "real_root: 2 real roots in [1, 2], not one", DomainError);
  CHECK_THROWS_AS(real_root({}, closed_interval(0, 1)), DomainError);
  CHECK_THROWS_AS(real_root({5}, closed_interval(0, 1)), DomainError);
  CHECK_THROWS_AS(real_root({-2, 0, 1}, closed_interval(2, 1)), DomainError);
}

TEST_CASE("real algebraic: numbers that differ by 10^-60 are told apart") {
  const Rational tiny = parse_rational("1e-60");
  CHECK(root_of(2) < root_of(2 + tiny));
  CHECK(root_of(2 + tiny) > root_of(2));
  CHECK(root_of(2) == root_of(2));
  const RealAlgebraic near(Rational(parse_rational("1.41421356237309504880168872420969807856967")));
  CHECK(near < root_of(2));
  CHECK(root_of(2) > near);
}

TEST_CASE("real algebraic: the same number from different intervals and polynomials is the same") {
  const RealAlgebraic narrow =
      real_root({-2, 0, 1}, closed_interval(Rational(14, 10), Rational(15, 10)));
  const RealAlgebraic wide = real_root({-4, 0, 0, 0, 1}, {Rational(0), std::nullopt});
  CHECK(narrow == wide);
  CHECK(wide == narrow);
  CHECK(real_root({-2, 0, 1}, closed_interval(-2, 0)) < narrow);
}

// Mignotte's polynomial: two of its roots, next to 10⁻³, differ by about 10⁻¹⁷.
TEST_CASE("real algebraic: a cluster of roots is enclosed and ordered") {
  Polynomial p = Polynomial::monomial(1, 10) - 2 * pow(Polynomial{-1, 1000}, 2);
  const Rational middle(1, 1000);
  const RealAlgebraic below = real_root(p, {Rational(0), middle});
  const RealAlgebraic above = real_root(p, {middle, Rational(1, 10)});
  CHECK(below < above);
  for (const long bits : {1L, 30L, 53L, 300L, 3000L}) {
    CHECK(has_accurate_ball(below, bits));
    CHECK(has_accurate_ball(above, bits));
  }
}

TEST_CASE("real algebraic: law: square roots are ordered as their squares") {
  for_samples(200, [](Random& random) {
    const Rational a = abs(random.rational());
    const Rational b = random.chance(4) ? a : Rational(abs(random.rational()));
    CHECK(compare(root_of(a), root_of(b)) == compare(RealAlgebraic(a), b));
    const Rational r = abs(random.rational());
    CHECK(compare(root_of(a), r) == compare(RealAlgebraic(a), r * r));
  });
}

TEST_CASE("real algebraic: law: the roots of a product are those of its factors, in order") {
  for_samples(100, [](Random& random) {
    const Polynomial p = random.nonconstant_polynomial(5);
    const Polynomial q = random.nonconstant_polynomial(5);
    std::vector<RealAlgebraic> roots;
    for (const Interval& i : isolate_real_roots(p * q, real_line())) {
      roots.push_back(real_root(p * q, i));
      const RealAlgebraic& root = roots.back();
      const bool of_p = count_real_roots(p, i) == 1;
      const bool of_q = count_real_roots(q, i) == 1;
      CHECK((sign_at(p, root) == 0) == of_p);
      CHECK((sign_at(q, root) == 0) == of_q);
      if (of_p) CHECK(real_root(p, i) == root);
      if (of_q) CHECK(real_root(q, i) == root);
      CHECK(factor(root.polynomial()).factors.size() == 1);
      CHECK(has_accurate_ball(root, random.integer(1, 400)));
    }
    for (std::size_t j = 0; j < roots.size(); ++j)
      for (std::size_t k = 0; k < roots.size(); ++k)
        CHECK(compare(roots[j], roots[k]) == (j <=> k));
  });
}

TEST_CASE("real algebraic: law: the sign of a product is that of its factors") {
  for_samples(100, [](Random& random) {
    const Polynomial p = random.nonconstant_polynomial(6);
    const auto intervals = isolate_real_roots(p, real_line());
    if (intervals.empty()) return;
    const RealAlgebraic a = real_root(p, intervals.front());
    const Polynomial q = random.polynomial(8);
    const Polynomial r = random.chance(4) ? a.polynomial() : random.polynomial(3);
    CHECK(sign_at(q * r, a) == sign_at(q, a) * sign_at(r, a));
    CHECK(is_root(q * r, a) == (sign_at(q * r, a) == 0));
    CHECK(is_root(p * q, a));
    CHECK(sign_at(q * q, a) >= 0);
    CHECK(sign_at(q * q + p * q + Polynomial{1}, a) == 1);
    const Rational t = random.rational();
    CHECK(compare(a, t) == (sign_at(Polynomial{-t, 1}, a) <=> 0));
  });
}

TEST_CASE("real roots: ascending, each once, with its order") {
  const Polynomial p =
      pow(Polynomial{-2, 0, 1}, 3) * pow(Polynomial{-3, 2}, 2) * Polynomial{1, 0, 1};
  const auto roots = real_roots(p, real_line());  // −√2, √2 and 3/2 between 1 and 2
  REQUIRE(roots.size() == 3);
  CHECK(roots[0] == RealRoot{real_root({-2, 0, 1}, {std::nullopt, Rational(0)}), 3});
  CHECK(roots[1] == RealRoot{real_root({-2, 0, 1}, {Rational(0), std::nullopt}), 3});
  CHECK(roots[2] == RealRoot{Rational(3, 2), 2});
  CHECK(real_roots(p, closed_interval(Rational(3, 2), 9)).size() == 1);
  CHECK(real_roots({1, 0, 1}, real_line()).empty());
  CHECK_THROWS_AS(real_roots({}, real_line()), DomainError);
}

TEST_CASE(
    "real algebraic: law: a rational root is found from its enclosures, an irrational is none") {
  for_samples(100, [](Random& random) {
    const Rational r = random.rational();
    const Polynomial rest = random.nonzero_polynomial(3);
    const Polynomial p = Polynomial{-r, 1} * rest;
    CHECK(rational_root(p, r, r, Real([r](long bits) { return RealBall(r, bits); })) == r);
    // square_root decides by the squares of numerator and denominator.
    for (const Rational& square : {Rational(r * r + 2), Rational(r * r + 3)}) {
      const Real root([square](long bits) { return sqrt(RealBall(square, bits), bits); });
      const RealBall near = root.enclose(64);
      CHECK(rational_root(Polynomial{-square, 0, 1} * rest, near.lower(), near.upper(), root) ==
            square_root(square));
    }
  });
}

TEST_CASE("real algebraic: a root next to a fraction that could be one is not rational") {
  // √(1/9 + 10⁻⁴⁰) = 1/3 + 1.5·10⁻⁴⁰ − …; the leading coefficient has the digits to tell.
  const Rational square = Rational(1, 9) + parse_rational("1e-40");
  const Real root([square](long bits) { return sqrt(RealBall(square, bits), bits); });
  CHECK(rational_root({-square, 0, 1}, 0, 1, root) == std::nullopt);
  CHECK(rational_root({-1, 3}, 0, 1, Rational(1, 3)) == Rational(1, 3));
  // −1/2 and 1/2 are both in the ball.
  const Real half([](long bits) { return RealBall(Rational(1, 2), std::max(bits, 2L)); });
  CHECK(rational_root({-1, 0, 4}, 0, 1, half) == Rational(1, 2));
}

TEST_CASE("real algebraic: a place is a number or a decimal, a long number abbreviated") {
  CHECK(place_text("t", Rational(1, 2)) == "t = 1/2");
  CHECK(place_text("s", Rational(-3)) == "s = -3");
  // ∛(1/5) = 0.584803547642573…
  CHECK(place_text("t", real_root({-1, 0, 0, 5}, closed_interval(0, 1))) == "t ≈ 0.584803547643");
  CHECK(place_text("t", parse_rational("1e-500")).size() < 90);
}

}  // namespace real_algebraic_test
