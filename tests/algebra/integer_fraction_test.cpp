#include "phrame/algebra/integer_fraction.hpp"

#include "support/random.hpp"

using namespace phrame;

TEST_CASE(
    "integer fraction: law: numerator/(scale·denominator) is n/d, the denominator primitive") {
  test::for_samples(60, [](test::Random& random) {
    const Polynomial n = random.polynomial(4);
    const Polynomial d = random.rational() * random.nonzero_polynomial(4);
    if (d.is_zero()) return;
    const auto [numerator, scale, denominator] = integer_fraction(n, d);
    const Polynomial e = to_polynomial(denominator.get());
    CHECK(scale > 0);
    CHECK(primitive_part(e) == e);
    CHECK(to_polynomial(numerator.get()) * d == Rational(scale) * (e * n));
  });
}
