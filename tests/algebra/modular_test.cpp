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

TEST_CASE("modular: law: a ring, and its derivation") {
  for_samples(100, [](Random& random) {
    const ulong prime = random_prime(random);
    const ModularPolynomial a = random_modular(random, prime, random.integer(0, 9));
    const ModularPolynomial b = random_modular(random, prime, random.integer(0, 9));
    // (ab)′ − a′b − ab′ = 0.
    ModularPolynomial product = a;
    product *= b;
    ModularPolynomial rest = differentiate(product);
    for (const auto& [f, g] : {std::pair{differentiate(a), b}, std::pair{a, differentiate(b)}}) {
      ModularPolynomial term = f;
      term *= g;
      rest -= term;
    }
    CHECK(rest.is_zero());
    const Word c = prime - 1;
    ModularPolynomial scaled = a;
    scaled *= c;
    scaled /= c;
    scaled -= a;
    CHECK(scaled.is_zero());
    const ModularPolynomial t_squared(prime, std::vector<Word>{0, 0, 1});
    ModularPolynomial raised = a;
    raised *= t_squared;
    ModularPolynomial back = shifted_down(raised, 2);
    back -= a;
    CHECK(back.is_zero());
  });
}

// x⁴ − 1 = (x − 1)(x + 1)(x² + 1) modulo 7, where −1 is no square; and (x + 1)²(x² + 1).
TEST_CASE("modular: the shapes of factors, and what is coprime") {
  const ModularPolynomial f(7, std::vector<Word>{6, 0, 0, 0, 1});
  long linear = 0;
  long quadratic = 0;
  for (const auto& [degree, exponent] : shapes_of_factors(f)) {
    CHECK(exponent == 1);
    (degree == 1 ? linear : quadratic) += 1;
  }
  CHECK(linear == 2);
  CHECK(quadratic == 1);
  const ModularPolynomial g(7, std::vector<Word>{1, 2, 2, 2, 1});
  bool has_square = false;
  for (const auto& [degree, exponent] : shapes_of_factors(g))
    has_square = has_square || (degree == 1 && exponent == 2);
  CHECK(has_square);
  CHECK_FALSE(are_coprime(f, g));
  CHECK(are_coprime(g, ModularPolynomial(7, std::vector<Word>{6, 1})));
  CHECK(residue(Integer(-1), 7) == 6);
  CHECK(residue(pow(Integer(10), 30), 7) == 1);
}

TEST_CASE("modular: law: a polynomial has the power sums of its roots, f′/f their series") {
  for_samples(60, [](Random& random) {
    const ulong p = (1UL << 61U) - 1;
    ModularPolynomial f(p, std::vector<Word>{1});
    std::vector<ulong> roots;
    for (long k = random.integer(1, 8); k > 0; --k) {
      roots.push_back(static_cast<ulong>(random.integer(0, 1'000'000)));
      f *= ModularPolynomial(p, std::vector<Word>{p - roots.back(), 1});
    }
    std::vector<ulong> sums;  // s₀, …, sₙ
    std::vector<ulong> powers(roots.size(), 1);
    const nmod_t mod = f.raw()->mod;
    for (std::size_t k = 0; k <= roots.size(); ++k) {
      ulong sum = 0;
      for (std::size_t i = 0; i < roots.size(); ++i) {
        sum = nmod_add(sum, powers[i], mod);
        powers[i] = nmod_mul(powers[i], roots[i], mod);
      }
      sums.push_back(sum);
    }
    const ModularPolynomial found = from_power_sums(p, {sums.begin() + 1, sums.end()});
    for (long k = 0; k <= f.degree(); ++k) CHECK(found.coefficient(k) == f.coefficient(k));
    // Σ s_k/t^{k+1} = f′/f.
    const ModularPolynomial slope = differentiate(f);
    const ModularPolynomial numerator = numerator_of_series({sums.begin(), sums.end() - 1}, f);
    CHECK(numerator.degree() == slope.degree());
    for (long k = 0; k <= slope.degree(); ++k)
      CHECK(numerator.coefficient(k) == slope.coefficient(k));
  });
}

TEST_CASE("modular: a product of values at roots, and powers, modulo a small prime") {
  constexpr Word p = 101;
  const auto linear = [&](Word root) { return ModularPolynomial(p, {p - root, 1}); };
  ModularPolynomial a = linear(2);  // 5·(t − 2)²·(t − 3)
  a *= linear(2);
  a *= linear(3);
  a *= Word{5};
  const ModularPolynomial b(p, {1, 0, 1});     // t² + 1: 5, 5 and 10
  const ModularPolynomial c(p, {0, 1, 0, 1});  // t³ + t: 10, 10 and 30
  CHECK(product_of_values(a, b, ModularPolynomial(p, {1})) == 250 % 101);
  // 250/3000 = 1/12, and 12·59 = 708 = 7·101 + 1.
  CHECK(product_of_values(a, b, c) == 59);
  CHECK_FALSE(product_of_values(a, b, linear(3)));
  CHECK_FALSE(product_of_values(ModularPolynomial(p), b, c));
  CHECK(power(3, 0, p) == 1);
  CHECK(power(3, 5, p) == 243 % 101);
}

TEST_CASE("modular: a common factor is never taken for none, not even one that is constant there") {
  const long p = static_cast<long>(Primes().next());
  const auto integral = [](const Polynomial& f) { return integer_numerator(f); };
  const Polynomial hidden{1, p};  // 1 modulo p
  CHECK_FALSE(are_seen_coprime(integral(hidden * Polynomial{2, 1}), integral(hidden)));
  CHECK_FALSE(is_seen_squarefree(integral(hidden * hidden * Polynomial{2, 1})));
  for_samples(200, [](Random& random) {
    const auto some = [&] {
      Polynomial f{random.integer(-9, 9), random.integer(-9, 9), random.integer(-9, 9)};
      return f.is_constant() ? Polynomial{random.integer(-9, 9), 1} : f;
    };
    const Polynomial a = some();
    const Polynomial b = some();
    const Polynomial c = some();
    CHECK_FALSE(are_seen_coprime(integer_numerator(a * c), integer_numerator(b * c)));
    CHECK_FALSE(is_seen_squarefree(integer_numerator(a * c * c)));
    const auto resultant = [](const Polynomial& f, const Polynomial& g) {
      Integer r;
      fmpz_poly_resultant(r.raw(), integer_numerator(f).get(), integer_numerator(g).get());
      return r;
    };
    CHECK(are_seen_coprime(integer_numerator(a), integer_numerator(b)) == (resultant(a, b) != 0));
    CHECK(is_seen_squarefree(integer_numerator(a)) == (resultant(a, differentiate(a)) != 0));
  });
}

// (u² + v² − p² − q²)² + (2uq + 2vp)² + (2vq − 2up)² = (u² + v² + p² + q²)² [Euler].
TEST_CASE("modular: a square is never taken for none") {
  int seen = 0;
  for_samples(200, [&](Random& random) {
    const Polynomial u = random.polynomial(3);
    const Polynomial v = random.polynomial(3);
    const Polynomial p = random.polynomial(3);
    const Polynomial q = random.polynomial(3);
    const Rational two(2);
    const Polynomial a = u * u + v * v - p * p - q * q;
    const Polynomial b = two * (u * q + v * p);
    const Polynomial c = two * (v * q - u * p);
    CHECK_FALSE(sum_of_squares_is_seen_no_square(a, b, c));
    CHECK_FALSE(sum_of_squares_is_seen_no_square(u, {}, {}));
    const bool is_seen = sum_of_squares_is_seen_no_square(u, v, p);
    if (is_seen) {
      CHECK_FALSE(square_root(u * u + v * v + p * p));
      ++seen;
    }
  });
  CHECK(seen > 50);
  // A denominator that is the prime, of which nothing is told.
  const Rational tiny(1, 2147483647);
  CHECK_FALSE(sum_of_squares_is_seen_no_square(Polynomial{3 * tiny}, Polynomial{4 * tiny}, {}));
}
