#include "phrame/algebra/ball_roots.hpp"

#include <algorithm>

#include "phrame/algebra/numerical_integral.hpp"
#include "phrame/algebra/rounding.hpp"
#include "support/random.hpp"

using namespace phrame;

// (t² + 1)(t − 1/3)(t + 7)
TEST_CASE("ball roots: real and complex ones, each once") {
  const Polynomial p = Polynomial{1, 0, 1} * Polynomial{Rational(-1, 3), 1} * Polynomial{7, 1};
  const BallRoots roots = ball_roots(BallPolynomial(p, 128), 128);
  REQUIRE(roots.are_isolated);
  REQUIRE(roots.all.size() == 4);
  std::vector<RealBall> real;
  for (const ComplexBall& root : roots.all) {
    if (root.im().is_zero()) {
      real.push_back(root.re());
      continue;
    }
    CHECK(root.re().contains(0));
    CHECK((root.im().contains(1) || root.im().contains(-1)));
  }
  REQUIRE(real.size() == 2);
  for (const Rational& x : {Rational(1, 3), Rational(-7)})
    CHECK(std::any_of(real.begin(), real.end(), [&](const RealBall& r) {
      return r.contains(x) && r.radius() < power_of_two(-100);
    }));
}

TEST_CASE("ball roots: what cannot be told apart is not said to be") {
  const BallPolynomial square(Polynomial{1, -2, 1}, 128);  // (t − 1)²
  CHECK_FALSE(ball_roots(square, 128).are_isolated);
  const BallPolynomial wide({RealBall(2, 64), hull(-9, 9, 64), RealBall(1, 64)});
  CHECK_FALSE(ball_roots(wide, 128).are_isolated);
}

TEST_CASE("integrand square root: the principal one, not across its cut") {
  const auto at = [](const Rational& re, const Rational& im) {
    return integrand_sqrt({RealBall(re, 64), RealBall(im, 64)}, 64);
  };
  CHECK(at(9, 0).re().contains(3));
  CHECK(at(-3, 4).re().contains(1));
  CHECK(at(-3, 4).im().contains(2));
  const ComplexBall across({RealBall(-4, 64), hull(-1, 1, 64)});
  CHECK_FALSE(integrand_sqrt(across, 64).re().is_finite());
}
