#include "phrame/algebra/surd_root.hpp"

#include "phrame/algebra/error.hpp"
#include "support/random.hpp"

using namespace phrame;
using test::for_samples;
using test::Random;

namespace {

RealBall real_value(const Radical& x) {
  const ComplexBall ball = enclose(x, 200);
  CHECK(ball.im().contains_zero());
  return ball.re();
}

}  // namespace

// √(5 + 2√6) = √2 + √3, √(3 − 2√2) = √2 − 1; √(10 − 2√5) stays, for 10² − 4·5 = 80 is no square.
TEST_CASE("surd root: roots that are sums of square roots are written so") {
  CHECK(times_root({1, 0}, {5, 2, 6}) == sqrt(Radical(3)) + sqrt(Radical(2)));
  CHECK(times_root({1, 0}, {3, -2, 2}) == sqrt(Radical(2)) - Radical(1));
  CHECK(times_root({0, 1, 2}, {Rational(1, 2), 0}) == Radical(1));
  CHECK(times_root({1, 0}, {10, -2, 5}) == sqrt(Radical(10) - Rational(2) * sqrt(Radical(5))));
  CHECK(times_root({-2, 0}, {10, -2, 5}) ==
        Rational(-2) * sqrt(Radical(10) - Rational(2) * sqrt(Radical(5))));
  CHECK(has_simple_root({5, 2, 6}));
  CHECK_FALSE(has_simple_root({10, -2, 5}));
  CHECK_FALSE(has_simple_root({0, 1, 2}));
  CHECK_THROWS_AS(times_root({1, 0}, {1, -1, 2}), DomainError);
  CHECK_THROWS_AS(times_root({1, 0}, {0, 0}), DomainError);
}

TEST_CASE("surd root: law: it is the product") {
  for_samples(200, [](Random& random) {
    const Integer d(random.integer(2, 3) + 4 * random.integer(0, 1));  // 2, 3, 6 or 7
    const auto number = [&] { return Surd{random.rational(), random.rational(), d}; };
    const Surd factor = number();
    Surd x = number();
    if (random.chance(2)) x = x * x;
    if (random.chance(2)) x = Surd{Rational(random.integer(1, 9)), 0} * x;
    if (sign(x) <= 0) x = -x;
    if (sign(x) == 0) return;
    const RealBall root = sqrt(real_value(to_radical(x)), 200);
    CHECK(real_value(times_root(factor, x))
              .overlaps(multiply(real_value(to_radical(factor)), root, 200)));
  });
}
