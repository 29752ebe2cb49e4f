#include "phrame/algebra/hadamard.hpp"

#include "phrame/algebra/bivariate.hpp"
#include "phrame/algebra/resultant.hpp"
#include "support/random.hpp"

namespace hadamard_test {

using namespace phrame;
using test::for_samples;
using test::Random;

namespace {

long bits(const flint::FmpzPoly& f) { return std::labs(fmpz_poly_max_bits(f.get())); }

flint::FmpzPoly integer_polynomial(const Polynomial& f) {
  flint::FmpzPoly result;
  fmpq_poly_get_numerator(result.get(), f.raw());
  REQUIRE(fmpz_is_one(fmpq_poly_denref(f.raw())) != 0);
  return result;
}

Rational resultant(const Polynomial& q, const Polynomial& a) {
  flint::Fmpq value;
  fmpq_poly_resultant(value.get(), q.raw(), a.raw());
  return Rational(value.get());
}

}  // namespace

TEST_CASE("hadamard: law: 2^bits bounds the norm, and Mahler's measure of known roots") {
  for_samples(100, [](Random& random) {
    Polynomial f{random.integer(1, 99)};
    Rational measure = f.coefficient(0);
    for (long k = random.integer(0, 6); k > 0; --k) {
      const Rational root = random.integer(-99, 99);
      f *= Polynomial{-root, 1};
      measure *= std::max(Rational(1), abs(root));
    }
    Rational squares = 0;
    for (const Rational& c : f.coefficients()) squares += c * c;
    const long bits = norm_bits(integer_polynomial(f));
    CHECK(squares <= Rational(pow(Integer(4), static_cast<unsigned long>(bits))));
    CHECK(measure <= Rational(pow(Integer(2), static_cast<unsigned long>(bits))));
    CHECK(squares * 16 > Rational(pow(Integer(4), static_cast<unsigned long>(bits))));
  });
}

// n and a may have a higher degree than q. R is the resultant of q and a as a polynomial of the
// formal degree, which is lead(q)^{formal − deg a}·res(q, a).
TEST_CASE("hadamard: law: R and R·n/a mod q are integral and below the bound") {
  for_samples(150, [](Random& random) {
    const Polynomial scale{0, random.chance(2) ? Rational(1) : Rational(1L << 40U)};
    Polynomial q = compose(primitive_part(random.nonconstant_polynomial(7)), scale);
    if (random.chance(3)) fmpq_poly_reverse(q.raw(), q.raw(), q.degree() + 1);
    if (q.is_constant()) return;
    const long more = random.chance(2) ? 0 : 9;
    const Polynomial a = primitive_part(random.nonzero_polynomial(q.degree() - 1 + more));
    const Polynomial n = primitive_part(random.polynomial(q.degree() - 1 + more));
    if (!gcd(a, q).is_constant()) return;
    Polynomial g;
    Polynomial s;
    Polynomial t;
    fmpq_poly_xgcd(g.raw(), s.raw(), t.raw(), a.raw(), q.raw());
    const long formal =
        formal_degree(integer_polynomial(n), integer_polynomial(a), integer_polynomial(q));
    Rational r = resultant(q, a);
    for (long k = a.degree(); k < formal; ++k) r *= q.leading_coefficient();
    const Polynomial c = r * ((n * s) % q);
    const long bound =
        cofactor_bits(integer_polynomial(n), integer_polynomial(a), integer_polynomial(q));
    CHECK(bits(integer_polynomial(c)) <= bound);
    CHECK(bits(integer_polynomial(Polynomial{r})) <= bound);
  });
}

TEST_CASE("hadamard: law: the residue polynomial is below its bound") {
  for_samples(60, [](Random& random) {
    const Polynomial scale{0, random.chance(2) ? Rational(1) : Rational(1L << 40U)};
    Polynomial d = compose(squarefree_part(random.nonconstant_polynomial(7)), scale);
    if (random.chance(3)) fmpq_poly_reverse(d.raw(), d.raw(), d.degree() + 1);
    if (d.is_constant()) return;
    const Polynomial n = primitive_part(random.polynomial(d.degree() - 1));
    // The leading coefficient of res_t(n − x·d′, d) is ±res(d, d′).
    const Polynomial primitive = residue_polynomial(n, d);
    const Polynomial r =
        Rational(resultant(d, differentiate(d)) / primitive.leading_coefficient()) * primitive;
    CHECK(bits(integer_polynomial(r)) <=
          residue_bits(integer_polynomial(n), integer_polynomial(d)));
  });
}

TEST_CASE("hadamard: roots that are all large, or all small, are not paid for") {
  Polynomial q{1};
  for (long k = 1; k <= 8; ++k) q *= Polynomial{-Rational(k) * Rational(1L << 40U), 1};
  for (int turn = 0; turn < 2; ++turn) {
    const Polynomial a = differentiate(q);
    Polynomial g;
    Polynomial s;
    Polynomial t;
    fmpq_poly_xgcd(g.raw(), s.raw(), t.raw(), a.raw(), q.raw());
    const long needed = bits(integer_polynomial(resultant(q, a) * s));
    CAPTURE(needed);
    CHECK(cofactor_bits(integer_polynomial({1}), integer_polynomial(a), integer_polynomial(q)) <
          needed + needed / 4);
    fmpq_poly_reverse(q.raw(), q.raw(), q.degree() + 1);
  }
}

TEST_CASE("hadamard: one small root does not hide that the others are large") {
  // ((t/2⁴⁰)⁷ − 1)·(2²⁰⁰t − 1)
  const Polynomial q =
      primitive_part(compose({-1, 0, 0, 0, 0, 0, 0, 1}, {0, Rational(1, 1L << 40U)}) *
                     Polynomial{-1, pow(Polynomial{2}, 200).coefficient(0)});
  const Polynomial a = differentiate(q);
  const long needed = bits(integer_polynomial(Polynomial{resultant(q, a)}));
  CHECK(cofactor_bits(integer_polynomial({1}), integer_polynomial(a), integer_polynomial(q)) <
        needed + needed / 4);
}

}  // namespace hadamard_test
