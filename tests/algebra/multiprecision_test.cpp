#include "phrame/algebra/multiprecision.hpp"

#include <doctest/doctest.h>

#include "phrame/algebra/error.hpp"
#include "support/random.hpp"

using namespace phrame;

TEST_CASE("multiprecision: law: Boost's numbers are the same and come back the same") {
  test::for_samples(200, [](test::Random& random) {
    const Rational x = random.rational();
    const auto boost = to_boost(x);
    CHECK(boost.str() == to_string(x));
    CHECK(from_boost(boost) == x);
    const Integer n = numerator(x) << 100;
    CHECK(to_boost(n).str() == n.str());
    CHECK(from_boost(to_boost(n)) == n);
  });
}

TEST_CASE("multiprecision: to mpfr_float with any number of bits") {
  const auto x = round_to_mpfr(Real([](long bits) { return pi(bits); }), 113);
  CHECK(mpfr_get_prec(x.backend().data()) == 113);
  mpfr_t expected;
  mpfr_init2(expected, 113);
  mpfr_const_pi(expected, MPFR_RNDN);  // MPFR rounds correctly
  CHECK(mpfr_equal_p(x.backend().data(), expected) != 0);
  mpfr_clear(expected);
  CHECK(round_to_mpfr(Rational(1, 3), 2) == 0.375);
  CHECK_THROWS_AS(round_to_mpfr(Rational(1, 3), 0), DomainError);
}
