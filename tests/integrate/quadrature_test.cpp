#include "phrame/integrate/quadrature.hpp"

#include "phrame/algebra/rounding.hpp"
#include "phrame/integrate/evaluator.hpp"
#include "phrame/integrate/integrate.hpp"
#include "support/random.hpp"

using namespace phrame;
using test::for_samples;
using test::Random;

TEST_CASE("quadrature: of 1/(1 + t²) from 0 to 1 is π/4, to the bits asked for") {
  for (const long bits : {20, 53, 200, 1000}) {
    const RealBall value = quadrature({Polynomial{4}, Polynomial{1, 0, 1}}, 0, 1, bits);
    CHECK(value.overlaps(pi(2000)));
    CHECK(value.radius() < Rational(1) / pow(Integer(2), static_cast<unsigned>(bits - 4)));
  }
}

// ∫₀¹ dt/((t − 1/2)² + ε²) = (2/ε)·arctan(1/2ε).
TEST_CASE("quadrature: poles near the path do not stop it") {
  const Rational epsilon(1, 1'000'000'000);
  const Polynomial d = pow(Polynomial{Rational(-1, 2), 1}, 2) + Polynomial{epsilon * epsilon};
  const RealBall value = quadrature({Polynomial{epsilon}, d}, 0, 1, 100);
  RealBall expected(1 / (2 * epsilon), 300);
  arb_atan(expected.raw(), expected.raw(), 300);
  CHECK(value.overlaps(multiply(expected, RealBall(2, 300), 300)));
  CHECK(value.radius() < Rational(1) / pow(Integer(2), 90));
}

TEST_CASE("quadrature: nor do poles so near that the denominator loses all its digits") {
  for (const char* text : {"1e-30", "1e-60"}) {
    const Rational epsilon = parse_rational(text);
    for (const Rational& middle : {Rational(1, 3), Rational(1), Rational(1) - epsilon}) {
      const Polynomial d = pow(Polynomial{-middle, 1}, 2) + Polynomial{epsilon * epsilon};
      const RealBall value = quadrature({Polynomial{epsilon}, d}, 0, 1, 100);
      const auto arctan = [&](const Rational& x) {
        RealBall y(x / epsilon, 400);
        arb_atan(y.raw(), y.raw(), 400);
        return y;
      };
      const RealBall expected = add(arctan(1 - middle), arctan(middle), 400);
      CHECK(value.overlaps(expected));
      CHECK(value.radius() < power_of_two(-90));
    }
  }
}

TEST_CASE("quadrature: a pole on the path gives no number") {
  const RealBall value = quadrature({Polynomial{1}, Polynomial{-1, 3}}, 0, 1, 53);
  CHECK((!value.is_finite() || value.radius() > 1));
}

TEST_CASE("quadrature: law: backwards it is the negative, and parts add up") {
  for_samples(30, [](Random& random) {
    const Polynomial d = pow(random.polynomial(3), 2) + Polynomial{1};
    const RationalFunction f(random.polynomial(5), d);
    const Rational a = random.rational();
    const Rational b = random.rational();
    const Rational c = random.rational();
    CHECK(add(quadrature(f, a, b, 80), quadrature(f, b, a, 80), 100).contains_zero());
    CHECK(add(quadrature(f, a, b, 80), quadrature(f, b, c, 80), 100)
              .overlaps(quadrature(f, a, c, 80)));
    CHECK(quadrature(f, a, b, 80).overlaps(Evaluator(integrate(f)).difference(a, b, 80)));
  });
}
