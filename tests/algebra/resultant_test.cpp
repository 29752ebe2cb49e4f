#include "phrame/algebra/resultant.hpp"

#include "phrame/algebra/error.hpp"
#include "support/random.hpp"

using namespace phrame;
using test::for_samples;
using test::Random;

namespace {

/// res_t(n − x·d′, d) for one rational x, by FLINT's own resultant, as a resultant of degrees
/// (deg d − 1, deg d) also where the leading coefficient of n − x·d′ vanishes: each degree missing
/// is a factor (−1)^{deg d}·lead(d).
Rational resultant_at(const Polynomial& n, const Polynomial& d, const Rational& x) {
  const Polynomial f = n - x * differentiate(d);
  if (f.is_zero()) return 0;
  flint::Fmpq value;
  fmpq_poly_resultant(value.get(), f.raw(), d.raw());
  Rational result = Rational(value.get());
  for (long k = f.degree(); k < d.degree() - 1; ++k)
    result *= (d.degree() % 2 == 0 ? 1 : -1) * d.leading_coefficient();
  return result;
}

}  // namespace

TEST_CASE("residue polynomial: those printed for the quintic of Farouki 2003") {
  // Reference values of section 4: for a/σ 1669067c⁴ − 28952c² − 224c + 160, for b/ρ (4c² + 1)².
  CHECK(residue_polynomial({0, -8, 8}, {6, -12, 46, -72, 37}) ==
        Polynomial{160, -224, -28952, 0, 1669067});
  CHECK(residue_polynomial({-96, -384, 416}, {720, -2976, 3376, -544, 80}) ==
        Polynomial{1, 0, 8, 0, 16});
}

TEST_CASE("residue polynomial: 1/(t² + 1) has the residues ±i/2, 1/t the residue 1") {
  CHECK(residue_polynomial({1}, {1, 0, 1}) == Polynomial{1, 0, 4});
  CHECK(residue_polynomial({1}, {0, 1}) == Polynomial{-1, 1});
  CHECK(residue_polynomial({Rational(2, 3)}, {0, 5}) == Polynomial{-2, 15});
  CHECK_THROWS_AS(residue_polynomial({1}, {5}), DomainError);
  CHECK_THROWS_AS(residue_polynomial({0, 1}, {0, 1}), DomainError);
  CHECK_THROWS_AS(residue_polynomial({1}, {1, 2, 1}), DomainError);
}

TEST_CASE("residue polynomial: law: proportional to FLINT's resultant at every x") {
  for_samples(60, [](Random& random) {
    const Polynomial d = squarefree_part(random.nonconstant_polynomial(9));
    const Polynomial n = random.polynomial(9) % d;
    const Polynomial r = residue_polynomial(n, d);
    CHECK(r.degree() == d.degree());
    // Two proportional functions: cross-multiplied with one point where neither vanishes.
    Rational anchor = 1;
    while (r(anchor) == 0) anchor += 1;
    const Rational there = resultant_at(n, d, anchor);
    CHECK(there != 0);
    for (long k = 0; k <= d.degree(); ++k) {
      const Rational x = random.rational();
      CHECK(r(x) * there == resultant_at(n, d, x) * r(anchor));
    }
  });
}

TEST_CASE("residues: where a prime tells them apart, the residue polynomial is squarefree") {
  CHECK(residues_are_distinct_modulo_a_prime({0, -8, 8}, {6, -12, 46, -72, 37}));
  CHECK_FALSE(residues_are_distinct_modulo_a_prime({-96, -384, 416}, {720, -2976, 3376, -544, 80}));
  // d′/d has all residues 1.
  CHECK_FALSE(residues_are_distinct_modulo_a_prime({1, 2, 3}, {5, 1, 1, 1}));
  for_samples(40, [](Random& random) {
    const Polynomial d = squarefree_part(random.nonconstant_polynomial(6));
    const Polynomial n = random.polynomial(6) % d;
    if (residues_are_distinct_modulo_a_prime(n, d)) CHECK(is_squarefree(residue_polynomial(n, d)));
  });
}

// The residues of t³/(t⁴ + 1) are all 1/4, those of 1/(t⁴ + 1) are −z/4.
TEST_CASE("residues modulo a prime: so many different ones, at least") {
  CHECK(distinct_residues_modulo_a_prime({0, 0, 0, 1}, {1, 0, 0, 0, 1}) == 1);
  CHECK(distinct_residues_modulo_a_prime({1}, {1, 0, 0, 0, 1}) == 4);
}
