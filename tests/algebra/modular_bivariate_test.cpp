#include "phrame/algebra/modular_bivariate.hpp"

#include "support/random.hpp"

using namespace phrame;

namespace {

constexpr Word prime = 101;

ModularPolynomial modular(const std::vector<Word>& ascending) { return {prime, ascending}; }

}  // namespace

// Over 𝔽₁₀₁[x]/(x² + 1): a = (t − x)(t − 1), b = (t − x)·2x·(t + 3).
TEST_CASE("modular bivariate: the monic gcd of two products with a common factor") {
  const ModularPolynomial q = modular({1, 0, 1});
  const ModularBivariate a{modular({0, 1}), modular({100, 100}), modular({1})};
  const ModularBivariate b{modular({6}), modular({2, 6}), modular({0, 2})};
  const auto g = monic_gcd(a, b, q);
  REQUIRE(g);
  REQUIRE(g->size() == 2);
  CHECK((*g)[0].coefficient(0) == 0);
  CHECK((*g)[0].coefficient(1) == 100);
  CHECK((*g)[1].degree() == 0);
  CHECK((*g)[1].coefficient(0) == 1);
}

// x² + 1 = (x − 10)(x + 10) modulo 101, so that x − 10 divides 0.
TEST_CASE("modular bivariate: a zero divisor leads nowhere") {
  const ModularPolynomial q = modular({1, 0, 1});
  CHECK_FALSE(monic_gcd({modular({1}), modular({1})}, {modular({3}), modular({91, 1})}, q));
}

TEST_CASE("modular bivariate: zeros at the end go") {
  ModularBivariate f{modular({0}), modular({5}), modular({0}), modular({})};
  normalize(f);
  CHECK(f.size() == 2);
}
