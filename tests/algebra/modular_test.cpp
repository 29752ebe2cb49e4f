#include "phrame/algebra/modular.hpp"

#include "support/random.hpp"

using namespace phrame;
using test::for_samples;
using test::Random;

namespace {

/// Small primes make leading coefficients vanish, so that degrees fall by more than one.
ulong random_prime(Random& random) {
  constexpr ulong largest = (1UL << 62U) - 57;
  if (random.chance(6)) return largest;
  return random.chance(2)
             ? n_nextprime(static_cast<ulong>(random.integer(2, 40)), 1)
             : n_nextprime((1UL << 61U) + static_cast<ulong>(random.integer(0, 999)), 1);
}

ModularPolynomial random_modular(Random& random, ulong prime, long degree) {
  ModularPolynomial f(prime);
  for (long k = 0; k <= degree; ++k)
    nmod_poly_set_coeff_ui(f.raw(), k, static_cast<ulong>(random.integer(0, LONG_MAX)) % prime);
  if (f.degree() < degree) nmod_poly_set_coeff_ui(f.raw(), degree, 1);
  return f;
}

}  // namespace

TEST_CASE("modular: law: a·a⁻¹ = 1 in 𝔽ₚ[t]/(q), and the resultant is FLINT's") {
  for_samples(400, [](Random& random) {
    const ulong p = random_prime(random);
    const long n = random.integer(1, random.chance(8) ? 90 : 9);
    const ModularPolynomial q = random_modular(random, p, n);
    const ModularPolynomial a =
        random_modular(random, p, random.chance(2) ? n - 1 : random.integer(0, n - 1));
    CAPTURE(p);
    CAPTURE(n);
    const ulong resultant = nmod_poly_resultant(q.raw(), a.raw());
    const auto inverse = modular_inverse(a, q);
    REQUIRE(inverse.has_value() == (resultant != 0));
    if (!inverse) return;
    CHECK(inverse->resultant == resultant);
    CHECK(inverse->inverse.degree() < n);
    ModularPolynomial one(p);
    nmod_poly_mulmod(one.raw(), a.raw(), inverse->inverse.raw(), q.raw());
    CHECK(nmod_poly_is_one(one.raw()) != 0);
  });
}

TEST_CASE("modular: law: the remainder is FLINT's, of any degrees") {
  for_samples(200, [](Random& random) {
    const ulong p = random_prime(random);
    const ModularPolynomial q = random_modular(random, p, random.integer(0, 40));
    ModularPolynomial a = random_modular(random, p, random.integer(0, random.chance(4) ? 200 : 50));
    if (random.chance(8)) nmod_poly_mul(a.raw(), a.raw(), q.raw());
    if (random.chance(20)) a = ModularPolynomial(p);
    ModularPolynomial expected(p);
    nmod_poly_rem(expected.raw(), a.raw(), q.raw());
    reduce(a, q);
    CHECK(nmod_poly_equal(a.raw(), expected.raw()) != 0);
  });
}

TEST_CASE("modular: law: the product modulo q is FLINT's, also where q is longer than it") {
  for_samples(200, [](Random& random) {
    const ulong p = random_prime(random);
    const long n = random.integer(1, random.chance(8) ? 90 : 9);
    const ModularPolynomial q = random_modular(random, p, n);
    ModularPolynomial a = random_modular(random, p, random.integer(0, n - 1));
    const ModularPolynomial b = random_modular(random, p, random.integer(0, n - 1));
    if (random.chance(10)) a = ModularPolynomial(p);
    ModularPolynomial expected(p);
    nmod_poly_mulmod(expected.raw(), a.raw(), b.raw(), q.raw());
    CHECK(nmod_poly_equal(multiply_modulo(a, b, q).raw(), expected.raw()) != 0);
  });
}

TEST_CASE("modular: the primes start above 2⁶¹, and none is left out, whoever asks") {
  Primes first;
  Primes second;
  ulong last = 1UL << 61U;
  for (int k = 0; k < 20; ++k) {
    const ulong p = first.next();
    CHECK(p == n_nextprime(last, 1));
    CHECK(second.next() == p);
    last = p;
  }
}
