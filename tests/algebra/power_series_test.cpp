#include "phrame/algebra/power_series.hpp"

#include "support/random.hpp"

using namespace phrame;
using test::for_samples;
using test::Random;

TEST_CASE("power series: what is cut off and what is turned round") {
  const Polynomial p{1, 2, 3};
  CHECK(truncated(p, 2) == Polynomial{1, 2});
  CHECK(truncated(p, 9) == p);
  CHECK(truncated(p, 0).is_zero());
  CHECK(reversed(p, 3) == Polynomial{3, 2, 1});
  CHECK(reversed(p, 5) == Polynomial{0, 0, 3, 2, 1});
}

TEST_CASE("power series: law: (exp p)′ = p′·exp p, and exp 0 = 1") {
  for_samples(100, [](Random& random) {
    const long n = random.integer(2, 12);
    const Polynomial p = Polynomial{0, 1} * random.polynomial(8);
    const Polynomial e = exp_series(p, n);
    CHECK(e.coefficient(0) == 1);
    CHECK(differentiate(e) == truncated(differentiate(p) * e, n - 1));
  });
}

TEST_CASE("power series: law: sums of powers of known roots, and the polynomial back") {
  for_samples(100, [](Random& random) {
    const long count = random.integer(1, 6);
    Polynomial p{1};
    std::vector<Rational> sums(static_cast<std::size_t>(count + 3));
    for (long k = 0; k < count; ++k) {
      const Rational root = random.rational();
      p *= Polynomial{-root, 1};
      Rational power = 1;
      for (Rational& s : sums) {
        s += power;
        power *= root;
      }
    }
    CHECK(power_sums_of_roots(Rational(7, 3) * p, count + 3) == Polynomial(sums));
    CHECK(with_power_sums(sums) == p);
  });
}
