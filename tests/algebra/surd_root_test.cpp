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
  CHECK(times_root(Surd(1), {5, 2, 6}) == sqrt(Radical(3)) + sqrt(Radical(2)));
  CHECK(times_root(Surd(1), {3, -2, 2}) == sqrt(Radical(2)) - Radical(1));
  CHECK(times_root({0, 1, 2}, {Rational(1, 2), 0}) == Radical(1));
  CHECK(times_root(Surd(1), {10, -2, 5}) == sqrt(Radical(10) - Rational(2) * sqrt(Radical(5))));
  CHECK(times_root(Surd(-2), {10, -2, 5}) ==
        Rational(-2) * sqrt(Radical(10) - Rational(2) * sqrt(Radical(5))));
  CHECK(simple_root({5, 2, 6}) == Surd(0, 1, 2) + Surd(0, 1, 3));
  CHECK_FALSE(simple_root({10, -2, 5}));
  CHECK_FALSE(simple_root({0, 1, 2}));
  CHECK_THROWS_AS(times_root(Surd(1), {1, -1, 2}), DomainError);
  CHECK_THROWS_AS(times_root(Surd(1), Surd(0)), DomainError);
}

TEST_CASE("surd root: law: it is the product") {
  for_samples(120, [](Random& random) {
    const Integer d(random.integer(2, 3) + 4 * random.integer(0, 1));  // 2, 3, 6 or 7
    const Integer e = random.chance(2) ? Integer(5) : d;  // ℚ(√d, √5) or ℚ(√d)
    const auto number = [&] {
      return Surd(random.rational(), random.rational(), d) +
             Surd(random.rational(), random.rational(), e) + Surd(0, e == d ? 0 : 1, d * e);
    };
    const Surd factor = number();
    Surd x = number();
    if (random.chance(2)) x = x * x;
    if (random.chance(2)) x = Rational(random.integer(1, 9)) * x;
    if (sign(x) <= 0) x = -x;
    if (sign(x) == 0) return;
    const RealBall root = sqrt(real_value(to_radical(x)), 200);
    CHECK(real_value(times_root(factor, x))
              .overlaps(multiply(real_value(to_radical(factor)), root, 200)));
  });
}

// From the unit circle: 2·sin(π/12) = √(2 − √3) = (√6 − √2)/2. √(10 + 2√6 + 2√10 + 2√15) is
// √2 + √3 + √5; times √7 it still is a sum of roots. √(√2 + √3) is none: its norm over ℚ(√2) is −1.
TEST_CASE("surd root: of numbers with several roots") {
  CHECK(simple_root({2, -1, 3}) == Surd(0, Rational(1, 2), 6) - Surd(0, Rational(1, 2), 2));
  const Surd three = Surd(0, 1, 2) + Surd(0, 1, 3) + Surd(0, 1, 5);
  CHECK(simple_root(three * three) == three);
  CHECK(simple_root(Rational(7) * three * three) == Surd(0, 1, 7) * three);
  CHECK_FALSE(simple_root(Surd(0, 1, 2) + Surd(0, 1, 3)));
  CHECK_FALSE(simple_root(three));
  // All conjugates are positive; the norm over ℚ(√2), 24 + 10√2, is no square, for 24² − 2·10² is
  // none.
  CHECK_FALSE(simple_root(Surd(5) + Surd(0, 1, 2) + Surd(0, 1, 3)));
  // (2 + √2)·(2 + √3)²: √(2 + √2) stays.
  const Surd y = Surd(2) + Surd(0, 1, 3);
  CHECK_FALSE(simple_root(Surd(2, 1, 2) * y * y));
}

TEST_CASE("surd root: law: √x·√x = x, and r·y² has a simple root") {
  for_samples(120, [](Random& random) {
    Surd y(random.rational());
    for (const long d : {2, 3, 6, 7}) y.add(random.chance(2) ? random.rational() : 0, d);
    if (y.is_zero()) return;
    const auto root = simple_root(Rational(random.integer(1, 30)) * y * y);
    REQUIRE(root);
    CHECK(sign(*root) > 0);
    const auto other = simple_root(sign(y) > 0 ? y : -y);
    if (other) CHECK(*other * *other == (sign(y) > 0 ? y : -y));
  });
}
