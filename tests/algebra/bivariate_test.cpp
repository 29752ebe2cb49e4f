#include "phrame/algebra/bivariate.hpp"

#include "phrame/algebra/error.hpp"
#include "phrame/algebra/hadamard.hpp"
#include "phrame/algebra/modular.hpp"
#include "support/random.hpp"

using namespace phrame;
using test::for_samples;
using test::Random;

TEST_CASE("bivariate: no leading zeros, and the value at t is a polynomial in x") {
  const Bivariate v({Polynomial{1, 2}, Polynomial{0, 1}, Polynomial{}});  // 1 + 2x + x·t
  CHECK(v.degree() == 1);
  CHECK(v.coefficient(5).is_zero());
  CHECK(evaluate_at(v, 3) == Polynomial{1, 5});
  CHECK(Bivariate({Polynomial{}}).is_zero());
}

TEST_CASE("bivariate: sums and products are those of all values") {
  const Bivariate a({Polynomial{1, 2}, Polynomial{0, 1}});
  const Bivariate b({Polynomial{3}, Polynomial{}, Polynomial{-1, 4, 2}});
  for (const Rational& t : {Rational(0), Rational(2), Rational(-1, 3)}) {
    CHECK(evaluate_at(a + b, t) == evaluate_at(a, t) + evaluate_at(b, t));
    CHECK(evaluate_at(a * b, t) == evaluate_at(a, t) * evaluate_at(b, t));
    CHECK(evaluate_at(Rational(3, 7) * b, t) == Rational(3, 7) * evaluate_at(b, t));
  }
  CHECK((a + Rational(-1) * a).is_zero());
  CHECK((a * Bivariate()).is_zero());
}

TEST_CASE("bivariate: the primitive part has coprime integers and a positive lead, row by row") {
  const Bivariate v({Polynomial{Rational(2, 3), 4}, Polynomial{}, Polynomial{0, Rational(-2, 5)}});
  CHECK(primitive_part(v) == Bivariate({Polynomial{-5, -30}, Polynomial{}, Polynomial{0, 3}}));
  const auto rows = integer_rows(v);
  REQUIRE(rows.size() == 3);
  CHECK(to_polynomial(rows[0].get()) == Polynomial{-5, -30});
  CHECK(to_polynomial(rows[1].get()).is_zero());
  CHECK(to_polynomial(rows[2].get()) == Polynomial{0, 3});
  CHECK(from_rows({1, 2, 3, 0}, 2) == std::vector<Polynomial>{{1, 2}, {3}});
}

TEST_CASE("quotient ring: √2 has inverse √2/2, trace 0; i has trace 0 and 1 has trace 2") {
  const QuotientRing ring({-2, 0, 1});
  CHECK(ring.divide({1}, {0, 1}) == Polynomial{0, Rational(1, 2)});
  CHECK(ring.multiply({0, 1}, {0, 1}) == Polynomial{2});
  CHECK(ring.trace({1}) == 2);
  CHECK(ring.trace({0, 1}) == 0);
  CHECK(ring.trace({0, 0, 1}) == 4);
  CHECK_THROWS_AS(QuotientRing({3}), DomainError);
  CHECK_THROWS_AS(QuotientRing({-1, 0, 1}).divide({1}, {-1, 1}), DomainError);
}

TEST_CASE("quotient ring: law: a·a⁻¹ = 1; the trace is the sum over known roots") {
  for_samples(100, [](Random& random) {
    Polynomial q{random.integer(1, 5)};
    std::vector<Rational> roots;
    for (long k = random.integer(1, 4); k > 0; --k) {
      roots.push_back(random.rational());
      q *= Polynomial{-roots.back(), 1};
    }
    const QuotientRing ring(q);
    const Polynomial a = random.polynomial(5);
    Rational sum = 0;
    for (const Rational& root : roots) sum += a(root);
    CHECK(ring.trace(a) == sum);
    if (gcd(a, q).is_constant() && !a.is_zero())
      CHECK(ring.multiply(a, ring.divide({1}, ring.reduce(a))) == Polynomial{1});
  });
}

TEST_CASE("quotient ring: law: n/a is n times the inverse by Euclid's algorithm over ℚ") {
  for_samples(150, [](Random& random) {
    const Polynomial q = random.nonconstant_polynomial(random.chance(6) ? 25 : 7);
    const Polynomial a = random.nonzero_polynomial(q.degree() + (random.chance(3) ? 12 : 2));
    const Polynomial n = random.polynomial(q.degree() + (random.chance(3) ? 20 : 2));
    const QuotientRing ring(q);
    Polynomial g;
    Polynomial s;
    Polynomial t;
    fmpq_poly_xgcd(g.raw(), s.raw(), t.raw(), a.raw(), q.raw());
    if (g == Polynomial{1})
      CHECK(ring.divide(n, a) == (n * s) % q);
    else
      CHECK_THROWS_AS(ring.divide(n, a), DomainError);
  });
}

TEST_CASE("quotient ring: primes that divide a leading coefficient or the resultant are avoided") {
  const Rational r(Integer(Primes().next()));
  const auto check = [](const Polynomial& a, const Polynomial& q) {
    const QuotientRing ring(q);
    CHECK(ring.multiply(a, ring.divide({3, 1}, a)) == Polynomial{3, 1});
  };
  check({1, 2, 3, 4}, {5, 0, 1, 0, r});
  check({1, 2, 0, r}, {5, 0, 1, 0, 7});
  check({1 + r, 1, 2}, {1, 2, 4, 3, 2});  // modulo the prime, a divides q
  check({r, 1}, {0, 1, 2, 0, 1});
  check({1, 2, 3, 4, 0, 0, r}, {5, 0, 1, 0, 7});  // of a higher degree than q
}

// Hadamard's bound of n/a mod q for the remainders of n and a modulo q, which have coefficients of
// 2000 digits, is 80 times what it is for n and a themselves, and so is the number of primes.
TEST_CASE("quotient ring: long remainders modulo q are not divided") {
  const auto integer = [](const Polynomial& p) { return integer_primitive_part(p); };
  test::Random random(2026);
  const auto dense = [&](long degree) {
    std::vector<Rational> c;
    for (long k = 0; k <= degree; ++k) c.emplace_back(random.integer(1, 1000));
    return Polynomial(c);
  };
  const Polynomial q = dense(30);
  const Polynomial a = dense(300);
  const Polynomial n = dense(320);
  const auto bits = [&](const Polynomial& x, const Polynomial& y) {
    return cofactor_bits(integer(x), integer(y), integer(q));
  };
  CHECK(bits(n, a) < bits(n % q, a % q) / 20);
  const QuotientRing ring(q);
  CHECK(ring.multiply(a, ring.divide(n, a)) == n % q);
}

TEST_CASE("power sums: of the roots 1, 2, 3, by hand") {
  // (t−1)(t−2)(t−3) = t³ − 6t² + 11t − 6
  const auto s = power_sums(std::vector<Rational>{-6, 11, -6}, 5, std::multiplies<Rational>());
  CHECK(s == std::vector<Rational>{6, 14, 36, 98, 276});
}
