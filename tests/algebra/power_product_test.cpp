#include "phrame/algebra/power_product.hpp"

#include "phrame/algebra/error.hpp"
#include "support/random.hpp"

using namespace phrame;
using test::for_samples;
using test::Random;

TEST_CASE("power product: ((1 + 2i)/3)² · (1/4)^{−1/2}, all exponents doubled") {
  const std::vector<Power> powers = {{{Rational(1, 3), Rational(2, 3)}, 2},
                                     {{Rational(1, 4), 0}, Rational(-1, 2)}};
  const Integer n = common_denominator(powers);
  CHECK(n == 2);
  // ((1 + 2i)/3)⁴ = ((−3 + 4i)/9)² = (−7 − 24i)/81, times 4.
  CHECK(product(powers, n) == GaussianRational{Rational(-28, 81), Rational(-96, 81)});
  CHECK(product({}, 1) == GaussianRational{1, 0});
}

TEST_CASE("power product: 0 is refused, results beyond the limit are not computed") {
  CHECK_THROWS_AS(product({{{0, 0}, -1}}, 1), DomainError);
  CHECK_FALSE(product({{{3, 1}, Rational(Integer(1) << 40U)}}, 1).has_value());
  CHECK_FALSE(product({{{3, 1}, Rational(Integer(1) << 400U)}}, 1).has_value());
}

TEST_CASE("power product: law: exponents add up, and opposite ones cancel") {
  for_samples(100, [](Random& random) {
    GaussianRational z{random.rational(), random.rational()};
    if (z.re == 0 && z.im == 0) return;
    const long a = random.integer(-6, 6);
    const long b = random.integer(-6, 6);
    CHECK(product({{z, a}, {z, b}}, 1) == product({{z, a + b}}, 1));
    CHECK(product({{z, a}, {z, -a}}, 3) == GaussianRational{1, 0});
  });
}
