#include "phrame/algebra/ball_powers.hpp"

#include "support/random.hpp"

using namespace phrame;
using test::for_samples;
using test::Random;

TEST_CASE("ball powers: law: the values of several polynomials at one number") {
  for_samples(100, [](Random& random) {
    const Rational x = random.rational();
    const BallPowers powers(RealBall(x, 100), 9, 100);
    for (int k = 0; k < 3; ++k) {
      const Polynomial p = random.polynomial(8);
      const RealBall value = powers.value_of(BallPolynomial(p, 100));
      CHECK(value.contains(p(x)));
      CHECK(value.overlaps(evaluate(BallPolynomial(p, 100), RealBall(x, 100), 100)));
    }
  });
}
