#include "phrame/algebra/bivariate_factor.hpp"

#include "phrame/algebra/error.hpp"
#include "support/random.hpp"

namespace bivariate_factor_test {

using namespace phrame;
using test::for_samples;
using test::Random;

namespace {

Bivariate random_bivariate(Random& random, long degree) {
  for (;;) {
    std::vector<Polynomial> rows;
    for (long k = 0; k <= degree; ++k) rows.push_back(random.polynomial(2));
    Bivariate v(std::move(rows));
    if (!v.is_zero()) return v;
  }
}

}  // namespace

TEST_CASE("bivariate factor: law: the product of the powers is primitive_part(v)") {
  for_samples(30, [](Random& random) {
    const Bivariate a = random_bivariate(random, random.integer(0, 2));
    const Bivariate v =
        a * random_bivariate(random, 2) * (random.chance(3) ? a : random_bivariate(random, 1));
    Bivariate product({Polynomial{1}});
    long last = 0;
    for (const auto& [base, exponent] : factor(v)) {
      CHECK(base == primitive_part(base));
      CHECK(base.degree() >= last);
      last = base.degree();
      for (long k = 0; k < exponent; ++k) product = product * base;
    }
    CHECK(primitive_part(product) == primitive_part(v));
  });
}

TEST_CASE("bivariate factor: t^2 - x^2 has two, t^2 - 2x^2 and t^2 - x one") {
  CHECK(factor(Bivariate({Polynomial{0, 0, -1}, {}, {1}})).size() == 2);
  CHECK(factor(Bivariate({Polynomial{0, 0, -2}, {}, {1}})).size() == 1);
  CHECK(factor(Bivariate({Polynomial{0, -1}, {}, {1}})).size() == 1);
  CHECK(factor(Bivariate({Polynomial{3}})).empty());
  CHECK_THROWS_AS(factor(Bivariate()), DomainError);
}

TEST_CASE("bivariate factor: law: gcd(ac, bc) is c times gcd(a, b)") {
  for_samples(20, [](Random& random) {
    const Bivariate a = random_bivariate(random, 2);
    const Bivariate b = random_bivariate(random, 2);
    const Bivariate c = random_bivariate(random, 1);
    CHECK(gcd(a * c, b * c) == primitive_part(gcd(a, b) * c));
    CHECK(gcd(a, Bivariate()) == primitive_part(a));
  });
  CHECK(gcd(Bivariate(), Bivariate()).is_zero());
}

}  // namespace bivariate_factor_test
