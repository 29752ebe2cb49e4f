#include "phrame/algebra/disc_evaluation.hpp"

#include "phrame/algebra/rounding.hpp"
#include "support/random.hpp"

using namespace phrame;
using test::for_samples;
using test::Random;

TEST_CASE(
    "disc evaluation: law: polynomials of integrands enclose their values on discs, again and "
    "again") {
  for_samples(20, [](Random& random) {
    const Polynomial p = random.polynomial(8);
    const IntegrandPolynomial kept = BallPolynomial(p, 200);
    const Rational middle(random.integer(-9, 9), 8);
    for (const Rational& radius : {Rational(1, 4), Rational(1, 64), Rational(2), Rational(0)}) {
      const RealBall side = hull(Rational(-radius), radius, 100);
      const ComplexBall disc(hull(Rational(middle - radius), Rational(middle + radius), 100), side);
      const ComplexBall values = kept(disc, 150);
      CHECK(values.overlaps(evaluate(BallPolynomial(p, 200), disc, 150)));
      for (const Rational& t : {Rational(middle - radius), middle, Rational(middle + radius)})
        CHECK(values.re().contains(p(t)));
    }
  });
}

// (t − 1)¹² on |t| ≤ 1/4 is at most (5/4)¹² < 15; Horner's rule gives sums of binomial
// coefficients.
TEST_CASE("disc evaluation: is not much wider on a disc than necessary") {
  const BallPolynomial p(pow(Polynomial{-1, 1}, 12), 200);
  const RealBall side = hull(Rational(-1, 8), Rational(1, 8), 100);
  CHECK(absolute(evaluate(p, ComplexBall(side, side), 100), 53).upper() < 15);
}

TEST_CASE("disc evaluation: a number is a point, a disc is not") {
  CHECK(is_point({RealBall(Rational(1, 3), 100), RealBall(Rational(1, 7), 100)}, 100));
  CHECK_FALSE(is_point({hull(1, 1 + power_of_two(-30), 100), {}}, 100));
}
