#include "phrame/algebra/radical.hpp"

#include "phrame/algebra/error.hpp"
#include "support/random.hpp"

namespace radical_test {

using namespace phrame;
using test::for_samples;
using test::Random;

namespace {

Radical root_of(long x) { return sqrt(Radical(x)); }

const Radical i = Radical::imaginary_unit();

ComplexBall exactly(const Rational& re, const Rational& im) {
  return {RealBall(re, 400), RealBall(im, 400)};
}

/// Do the two numbers agree to 300 bits?
bool agree(const Radical& a, const Radical& b) {
  const ComplexBall x = enclose(a, 300);
  return x.overlaps(enclose(b, 300)) && x.re().is_accurate(300) && x.im().is_accurate(300);
}

/// a + b·√d + (c + e·√d)·i.
Radical random_number(Random& random) {
  const Radical d = sqrt(Radical(random.integer(-30, 30)));
  return random.rational() + random.rational() * d +
         (random.rational() + random.rational() * d) * i;
}

}  // namespace

TEST_CASE("radical: terms are collected, contents taken out, i and square roots multiplied") {
  CHECK(i * i == Radical(-1));
  CHECK(root_of(2) * root_of(2) == Radical(2));
  CHECK(root_of(12) == 2 * root_of(3));
  CHECK(sqrt(Radical(Rational(-1, 2))) == i * root_of(2) / 2);
  CHECK(cbrt(Radical(Rational(16, 27))) == 2 * cbrt(Radical(2)) / 3);
  CHECK(cbrt(Radical(-16)) == 2 * cbrt(Radical(-2)));
  CHECK(cbrt(Radical((Integer(1) << 89U) - 1)).steps().size() == 1);
  CHECK(sqrt(Radical(Rational(9, 4))) == Radical(Rational(3, 2)));
  CHECK(sqrt(Radical(0)) == Radical(0));
  CHECK(cbrt(Radical(0)) == Radical(0));
  CHECK(root_of(2) + root_of(3) - root_of(2) == root_of(3));
  CHECK((root_of(2) - root_of(2)).rational() == Rational(0));
  CHECK((1 + root_of(5)) * 3 / 6 == Rational(1, 2) + root_of(5) / 2);
  CHECK((2 + 4 * root_of(5)) * (3 * root_of(2)) == 6 * ((1 + 2 * root_of(5)) * root_of(2)));
  CHECK(sqrt(4 + 8 * root_of(5)) == 2 * sqrt(1 + 2 * root_of(5)));
  CHECK(root_of(2).rational() == std::nullopt);
}

TEST_CASE("radical: equal parts are one step, and steps no longer needed are dropped") {
  const Radical s = sqrt(1 + root_of(2));
  CHECK(s.steps().size() == 2);
  CHECK((s + root_of(2) * s + 1 / s).steps().size() == 4);
  CHECK((s + root_of(3) - s).steps().size() == 1);
}

TEST_CASE("radical: a division by 0 throws, or ends undecided where the 0 is hidden") {
  CHECK_THROWS_AS(root_of(2) / Radical(0), DomainError);
  const Radical hidden = root_of(2) * root_of(3) - root_of(6);
  CHECK_THROWS_AS(enclose(1 / hidden, 53), Undecided);
  CHECK(enclose(hidden, 53).re().contains_zero());
}

TEST_CASE("radical: roots are principal, on the negative axis too") {
  const auto contains = [](const Radical& x, const ComplexBall& z) {
    return enclose(x, 200).overlaps(z);
  };
  CHECK(contains(sqrt(Radical(-4)), exactly(0, 2)));
  CHECK(agree(cbrt(Radical(-8)), 1 + i * root_of(3)));
  CHECK(contains(sqrt(3 + 4 * i), exactly(2, 1)));
  CHECK(contains(sqrt(3 - 4 * i), exactly(2, -1)));
  CHECK(contains(sqrt(-3 + 4 * i), exactly(1, 2)));
  CHECK(contains(sqrt(-3 - 4 * i), exactly(1, -2)));
  CHECK(contains(cbrt(2 + 11 * i), exactly(2, 1)));
  CHECK(agree(cbrt(-2 + 11 * i), (1 + i * root_of(3)) / 2 * (2 - i)));
  CHECK(agree(sqrt(Radical(-1) * (1 + root_of(2))), i * sqrt(1 + root_of(2))));
}

TEST_CASE("radical: law: enclosures obey the laws of numbers") {
  for_samples(60, [](Random& random) {
    const Radical a = random_number(random);
    const Radical b = random_number(random);
    const Radical c = random_number(random);
    CHECK(agree((a + b) * c, a * c + b * c));
    CHECK(agree(a * b, b * a));
    CHECK(agree((a - b) * (a + b), a * a - b * b));
    if (b.rational() != Rational(0)) CHECK(agree(a / b * b, a));
    if (a.rational() == Rational(0)) return;
    const Radical s = sqrt(a);
    const Radical t = cbrt(a);
    CHECK(agree(s * s, a));
    CHECK(agree(t * t * t, a));
    // −π/2 < arg s ≤ π/2 and −π/3 < arg t ≤ π/3.
    const ComplexBall s_ball = enclose(s, 100);
    const ComplexBall t_ball = enclose(t, 100);
    CHECK(s_ball.re().upper() >= 0);
    CHECK((s_ball.re().upper() > 0 || s_ball.im().lower() >= 0));
    CHECK(t_ball.re().lower() > 0);
    CHECK(abs(t_ball.im().lower()) < Rational(174, 100) * t_ball.re().upper());
  });
}

TEST_CASE("radical: a polynomial at a radical") {
  CHECK(evaluate({-2, 0, 1}, root_of(2)) == Radical(0));
  CHECK(evaluate({1, 2}, root_of(2)) == 1 + 2 * root_of(2));
  CHECK(evaluate(Polynomial{}, root_of(2)) == Radical(0));
  const Radical x = cbrt(Radical(5)) + i;
  CHECK(agree(evaluate({1, -2, 3, 1}, x), 1 - 2 * x + 3 * x * x + x * x * x));
}

}  // namespace radical_test
