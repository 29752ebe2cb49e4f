#include "phrame/algebra/known_factor.hpp"

#include "phrame/algebra/error.hpp"
#include "support/random.hpp"

using namespace phrame;
using test::for_samples;
using test::Random;

namespace {

Polynomial product(const Factorization& f) {
  Polynomial p{f.unit};
  for (const auto& [base, exponent] : f.factors) p *= pow(base, exponent);
  return p;
}

}  // namespace

TEST_CASE("factor: t⁴ + 4 splits over ℚ, t⁴ + 1 does not (Sophie Germain)") {
  const auto f = factor({4, 0, 0, 0, 1});
  REQUIRE(f.factors.size() == 2);
  CHECK(f.factors[0].base == Polynomial{2, -2, 1});
  CHECK(f.factors[1].base == Polynomial{2, 2, 1});
  CHECK(factor({1, 0, 0, 0, 1}).factors.size() == 1);
}

TEST_CASE("factor: order and unit") {
  const auto f = factor(Rational(-4) * Polynomial{0, -1, 1});  // −4t(t − 1)
  CHECK(f.unit == -4);
  REQUIRE(f.factors.size() == 2);
  CHECK(f.factors[0] == Factor{Polynomial{0, 1}, 1});
  CHECK(f.factors[1] == Factor{Polynomial{-1, 1}, 1});
  CHECK(factor(Polynomial{Rational(3, 7)}).unit == Rational(3, 7));
  CHECK_THROWS_AS(factor(Polynomial{}), DomainError);
  CHECK_THROWS_AS(squarefree_factorization({}), DomainError);
}

TEST_CASE("factor: a known coprime divisor changes nothing") {
  for_samples(60, [](Random& random) {
    const Polynomial a = random.repeated_polynomial(2);
    const Polynomial b = random.repeated_polynomial(2);
    if (!gcd(a, b).is_constant()) return;
    for (const Polynomial& divisor : {a, b, Rational(-3, 2) * a, a * b, Polynomial{2}}) {
      const Factorization known = factor(a * b, divisor);
      CHECK(known.unit == factor(a * b).unit);
      CHECK(known.factors == factor(a * b).factors);
    }
  });
}

TEST_CASE("factor: law: the factors multiply to p; squarefree bases, coprime, distinct exponents") {
  for_samples(80, [](Random& random) {
    const Polynomial p = random.repeated_polynomial(3);
    CHECK(product(factor(p)) == p);
    const auto squarefree = squarefree_factorization(p);
    CHECK(product(squarefree) == p);
    for (std::size_t j = 0; j < squarefree.factors.size(); ++j) {
      CHECK(is_squarefree(squarefree.factors[j].base));
      for (std::size_t k = 0; k < j; ++k) {
        CHECK(gcd(squarefree.factors[j].base, squarefree.factors[k].base).is_constant());
        CHECK(squarefree.factors[j].exponent != squarefree.factors[k].exponent);
      }
    }
  });
}
