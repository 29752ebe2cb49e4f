#include "phrame/algebra/ball.hpp"

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
  const RealBall cut = argument(ComplexBall(RealBall(-1, 64), hull(-1, 1, 64)), 64);
  CHECK(cut.contains(3));
  CHECK(cut.contains(-3));
}
