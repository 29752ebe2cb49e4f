#include "phrame/algebra/error.hpp"
#include "phrame/integrate/hermite.hpp"
#include "support/linear_system.hpp"
#include "support/random.hpp"

using namespace phrame;
using test::for_samples;
using test::horowitz_reduce;
using test::Random;

TEST_CASE("hermite: Bronstein's example 2.2.1") {
  // ∫ (t⁷ − 24t⁴ − 4t² + 8t − 8)/(t⁸ + 6t⁶ + 12t⁴ + 8t²) = 1/t + 6t/(t² + 2)² − (t − 3)/(t² + 2) +
  // log t
  const RationalFunction f({-8, 8, -4, 0, -24, 0, 0, 1}, {0, 0, 8, 0, 12, 0, 6, 0, 1});
  const RationalFunction rational = RationalFunction({1}, {0, 1}) +
                                    RationalFunction({0, 6}, {4, 0, 4, 0, 1}) -
                                    RationalFunction({-3, 1}, {2, 0, 1});
  const auto part = hermite_reduce(f);
  CHECK(part.rational == rational);
  CHECK(part.rest == RationalFunction({1}, {0, 1}));
  CHECK(horowitz_reduce(f) == part);
}

TEST_CASE("hermite: a squarefree denominator is left alone, an improper function refused") {
  const RationalFunction f({1}, {-1, 0, 1});
  CHECK(hermite_reduce(f) == RationalPart{{}, f});
  CHECK(horowitz_reduce(f) == RationalPart{{}, f});
  CHECK(hermite_reduce({}) == RationalPart{});
  CHECK_THROWS_AS(hermite_reduce(RationalFunction({0, 1})), DomainError);
}

TEST_CASE("hermite: law: rational′ + rest = f, rest has simple poles, Horowitz agrees") {
  for_samples(60, [](Random& random) {
    const Polynomial d = random.repeated_polynomial(3);
    const RationalFunction f(random.polynomial(8) % d, d);
    const auto part = hermite_reduce(f);
    CHECK(differentiate(part.rational) + part.rest == f);
    CHECK(is_squarefree(part.rest.denominator()));
    CHECK(part.rest.is_proper());
    CHECK(part.rational.is_proper());
    CHECK(horowitz_reduce(f) == part);
  });
}

TEST_CASE("hermite: ∏(t − k)ᵏ, k ≤ 8, against Horowitz") {
  Polynomial d{1};
  for (long k = 1; k <= 8; ++k) d *= pow(Polynomial{-k, 1}, k);
  const RationalFunction f({1}, d);
  const auto part = hermite_reduce(f);
  CHECK(differentiate(part.rational) + part.rest == f);
  CHECK(horowitz_reduce(f) == part);
}
