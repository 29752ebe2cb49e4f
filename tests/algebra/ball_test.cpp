#include "phrame/algebra/ball.hpp"

#include <cmath>

#include "support/random.hpp"

using namespace phrame;
using test::for_samples;
using test::Random;

TEST_CASE("ball: law: operations contain the exact result, and are narrow") {
  for_samples(200, [](Random& random) {
    const Rational x = random.rational();
    const Rational y = random.rational();
    const long bits = random.integer(20, 300);
    const RealBall a(x, bits);
    const RealBall b(y, bits);
    CHECK(a.contains(x));
    CHECK(a.lower() <= x);
    CHECK(x <= a.upper());
    CHECK(add(a, b, bits).contains(x + y));
    CHECK(subtract(a, b, bits).contains(x - y));
    CHECK(multiply(a, b, bits).contains(x * y));
    if (y != 0) CHECK(divide(a, b, bits).contains(x / y));
    CHECK(sqrt(RealBall(x * x, bits), bits).contains(abs(x)));
    CHECK(multiply(a, b, bits).radius() <= (abs(x * y) + 1) * parse_rational("0x1p-10"));
    const auto [c, s] = cos_sin(a, bits);
    CHECK(add(multiply(c, c, bits), multiply(s, s, bits), bits).contains(1));
  });
}

TEST_CASE("ball: law: a polynomial at a Gaussian rational contains the exact value") {
  for_samples(100, [](Random& random) {
    const Polynomial p = random.polynomial(6);
    const Rational x = random.rational();
    const Rational y = random.rational();
    // Horner's rule in ℚ(i), by hand.
    Rational re = 0;
    Rational im = 0;
    for (long k = p.degree(); k >= 0; --k) {
      const Rational next = re * x - im * y + p.coefficient(k);
      im = re * y + im * x;
      re = next;
    }
    const ComplexBall z(RealBall(x, 200), RealBall(y, 200));
    const ComplexBall value = evaluate(p, z, 200);
    CHECK(value.re().contains(re));
    CHECK(value.im().contains(im));
    CHECK(conjugate(value).im().contains(-im));
  });
}

TEST_CASE("ball: law: a polynomial on a real ball contains its values there, exactly at a point") {
  for_samples(100, [](Random& random) {
    const Polynomial p = random.polynomial(6);
    const Rational x = random.rational();
    RealBall ball(x, 200);
    CHECK(evaluate(p, ball, 200).contains(p(x)));
    arb_add_error_2exp_si(ball.raw(), -3);
    const RealBall wide = evaluate(p, ball, 200);
    CHECK(wide.contains(p(x - Rational(1, 8))));
    CHECK(wide.contains(p(x + Rational(1, 8))));
  });
  CHECK(evaluate({1, 2, Rational(1, 4)}, RealBall(2, 64), 64).radius() == 0);
}

TEST_CASE("ball: accuracy is relative above 1 and absolute below") {
  RealBall ball(1024, 64);
  arb_add_error_2exp_si(ball.raw(), -10);
  CHECK(ball.is_accurate(19));
  CHECK_FALSE(ball.is_accurate(21));
  RealBall small;
  arb_add_error_2exp_si(small.raw(), -10);
  CHECK(small.is_accurate(10));
  CHECK_FALSE(small.is_accurate(11));
}

TEST_CASE("ball: zero, overlap and text") {
  CHECK(RealBall().contains_zero());
  CHECK_FALSE(RealBall(Rational(1, 3), 30).contains_zero());
  CHECK(RealBall(Rational(1, 3), 30).overlaps(RealBall(Rational(1, 3), 60)));
  CHECK_FALSE(RealBall(1, 30).overlaps(RealBall(2, 30)));
  CHECK_FALSE(divide(RealBall(1, 30), RealBall(), 30).is_finite());
  CHECK(to_string(RealBall(Rational(-1, 4), 100), 12) == "-0.250000000000");
  CHECK(to_string(RealBall(), 12) == "0");
}

TEST_CASE("ball: hulls, and arguments in all directions") {
  const RealBall wide = hull(Rational(-1, 3), Rational(2), 64);
  for (const Rational& x : {Rational(-1, 3), Rational(0), Rational(2)}) CHECK(wide.contains(x));
  CHECK(wide.radius() < 2);
  const RealBall both = hull(RealBall(1, 64), RealBall(Rational(1, 3), 64), 64);
  CHECK(both.contains(1));
  CHECK(both.contains(Rational(1, 3)));
  for (const auto& [re, im] : {std::pair(1, 1), std::pair(-1, 1), std::pair(-2, -3)})
    CHECK(argument(ComplexBall(RealBall(re, 64), RealBall(im, 64)), 64)
              .overlaps(argument(Rational(re), Rational(im), 64)));
  // On the cut the whole circle is returned.
  // Through the cut: arg(−1 + iy) = π − arctan y.
  const RealBall through = argument_about_pi(ComplexBall(RealBall(-1, 64), hull(-1, 1, 64)), 64);
  CHECK(through.overlaps(divide(pi(64), RealBall(Rational(4, 3), 64), 64)));
  CHECK(through.overlaps(divide(pi(64), RealBall(Rational(4, 5), 64), 64)));
  CHECK(through.radius() < Rational(1));
  const RealBall cut = argument(ComplexBall(RealBall(-1, 64), hull(-1, 1, 64)), 64);
  CHECK(cut.contains(3));
  CHECK(cut.contains(-3));
}

TEST_CASE(
    "ball: law: powers of two and sums of doubles are exact, other operations contain theirs") {
  for_samples(200, [](Random& random) {
    const Rational x = random.rational();
    const Rational y = random.rational();
    const Rational z = random.rational();
    const long bits = random.integer(20, 300);
    const RealBall a(x, bits);
    const RealBall b(y, bits);
    const long k = random.integer(-200, 200);
    const Rational power = k < 0 ? Rational(1) / pow(Integer(2), static_cast<unsigned long>(-k))
                                 : Rational(pow(Integer(2), static_cast<unsigned long>(k)));
    CHECK(times_power_of_two(a, k).midpoint() == power * a.midpoint());
    CHECK(times_power_of_two(a, k).radius() == power * a.radius());
    CHECK(add_product(RealBall(z, bits), a, b, bits).contains(x * y + z));
    CHECK(pow(a, 3, bits).contains(x * x * x));
    CHECK(sqrt_of_nonnegative(RealBall(x * x, bits), bits).contains(abs(x)));
    const RealBall wide = widened(a, b);
    for (const Rational& end : {Rational(x - y), Rational(x + y)}) CHECK(wide.contains(end));
    const auto s = static_cast<double>(x);
    const auto t = static_cast<double>(y) * 0x1p-200;
    CHECK(exact_sum(s, t).radius() == 0);
    CHECK(exact_sum(s, t).midpoint() == exact_rational(s) + exact_rational(t));
    const RealBall little_wider = widened(a, std::abs(t));
    CHECK(little_wider.contains(x + exact_rational(t)));
    CHECK(little_wider.contains(x - exact_rational(t)));
  });
}

TEST_CASE("ball: a root of what is not negative has no imaginary part to fear") {
  const RealBall x = hull(Rational(-1, 4), Rational(4), 100);
  CHECK_FALSE(sqrt(x, 100).is_finite());
  CHECK(sqrt_of_nonnegative(x, 100).contains(0));
  CHECK(sqrt_of_nonnegative(x, 100).contains(2));
}

TEST_CASE("ball: what is not known may be any number") {
  CHECK_FALSE(RealBall::unknown().is_finite());
  CHECK_FALSE(RealBall::unknown().is_zero());
  CHECK_FALSE(ComplexBall::unknown().re().is_finite());
  CHECK_FALSE(ComplexBall::unknown().im().is_finite());
  CHECK(RealBall().is_zero());
  CHECK_FALSE(hull(Rational(-1), Rational(1), 53).is_zero());
}

TEST_CASE("ball: law: complex inverses, sizes, midpoints and what contains what") {
  for_samples(200, [](Random& random) {
    const Rational x = random.rational();
    const Rational y = random.rational();
    if (x == 0 && y == 0) return;
    const ComplexBall z(RealBall(x, 100), RealBall(y, 100));
    const ComplexBall inverted = inverse(z, 100);
    CHECK(inverted.re().contains(x / (x * x + y * y)));
    CHECK(inverted.im().contains(-y / (x * x + y * y)));
    const RealBall size = absolute(z, 100);
    CHECK(multiply(size, size, 100).contains(x * x + y * y));
    CHECK(z.accuracy_bits() > 90);
    const ComplexBall middle = z.midpoint();
    CHECK(middle.re().radius() == 0);
    CHECK(z.contains(middle));
    CHECK(z.is_same_ball(z));
    const ComplexBall larger(widened(z.re(), 1.0), widened(z.im(), 1.0));
    CHECK(larger.contains(z));
    CHECK_FALSE(z.contains(larger));
    CHECK_FALSE(z.is_same_ball(larger));
  });
}
