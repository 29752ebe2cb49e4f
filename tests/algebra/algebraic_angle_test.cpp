#include "phrame/algebra/algebraic_angle.hpp"

#include <doctest/doctest.h>

#include "phrame/algebra/angle.hpp"
#include "phrame/algebra/ball_order.hpp"
#include "phrame/algebra/error.hpp"
#include "phrame/algebra/rounding.hpp"
#include "phrame/algebra/surd.hpp"
#include "support/random.hpp"

using namespace phrame;

namespace algebraic_angle_test {

AlgebraicAngle arg(const Rational& x, const Rational& y, const Rational& d = 1) {
  return AlgebraicAngle::argument(x, y, d);
}

AlgebraicAngle times(long n, const AlgebraicAngle& angle) {
  AlgebraicAngle sum;
  for (long k = 0; k < n; ++k) sum = sum + angle;
  return sum;
}

/// By balls.
Real argument_value(const AlgebraicAngle& angle, const Rational& x, const Rational& y,
                    const Rational& d) {
  const auto enclosure = [x, y, d](long bits) {
    const RealBall im = multiply(RealBall(y, bits), sqrt(RealBall(d, bits), bits), bits);
    return argument(ComplexBall(RealBall(x, bits), im), bits);
  };
  return real_angle(enclosure, {0, [angle] { return angle; }}, 0);
}

}  // namespace algebraic_angle_test

using namespace algebraic_angle_test;

TEST_CASE("algebraic angle: arguments that are multiples of π, and others") {
  CHECK(AlgebraicAngle().half_turns() == Rational(0));
  CHECK(AlgebraicAngle(Rational(-7, 3)).half_turns() == Rational(-1, 3));
  CHECK(arg(-2, 0).half_turns() == Rational(1));
  CHECK(arg(0, -3, 7).half_turns() == Rational(-1, 2));
  CHECK(arg(-1, 1).half_turns() == Rational(3, 4));
  CHECK(arg(Rational(1, 2), Rational(-1, 4), 12).half_turns() == Rational(-1, 3));
  CHECK(arg(3, 1, 3).half_turns() == Rational(1, 6));
  CHECK(arg(1, Rational(1, 2), 4).half_turns() == Rational(1, 4));
  CHECK_FALSE(arg(2, 1).half_turns());
  CHECK_FALSE(arg(1, 1, 2).half_turns());
  CHECK_THROWS_AS(arg(0, 0), DomainError);
  CHECK_THROWS_AS(arg(1, 1, -1), DomainError);
}

TEST_CASE("algebraic angle: Machin's formula, Euler's, and the angles of a tetrahedron [Dehn]") {
  const AlgebraicAngle fifth = arg(5, 1);
  CHECK((times(4, fifth) + -arg(239, 1)).half_turns() == Rational(1, 4));
  CHECK_FALSE((times(4, fifth) + -arg(238, 1)).half_turns());
  CHECK((arg(2, 1) + arg(3, 1)).half_turns() == Rational(1, 4));
  const AlgebraicAngle dihedral = arg(1, 1, 8);  // arccos(1/3)
  CHECK_FALSE(times(6, dihedral).half_turns());
  // That of the octahedron is its supplement.
  CHECK((dihedral + arg(-1, 2, 2)).half_turns() == Rational(1));
  // Another root does not cancel it.
  CHECK_FALSE((dihedral + arg(1, 1, 3) + arg(2, 1, 5)).half_turns());
}

// With U = Π zₖ in ℚ(i, √2, √3) the angle is a rational multiple of π just where U/Ū is a root of
// unity, all of which there have orders that divide 24: where U²⁴ is real.
TEST_CASE("algebraic angle: law: decided as the 24th power of the product in ℚ(i, √2, √3) is") {
  long rational = 0;
  test::for_samples(60, [&](test::Random& random) {
    AlgebraicAngle angle;
    Surd re(1);
    Surd im;
    const auto multiply_by = [&](const Rational& x, const Rational& y, long d) {
      angle = angle + arg(x, y, d);
      const Surd root(0, y, d);
      const Surd old = re;
      re = x * re - root * im;
      im = x * im + root * old;
    };
    const long count = random.integer(1, 4);
    for (long k = 0; k < count; ++k) {
      const std::array<long, 6> radicands{1, 2, 3, 6, 12, 18};
      const long d = radicands[static_cast<std::size_t>(random.integer(0, 5))];
      const Rational x = random.integer(-2, 3);
      const Rational y = random.integer(1, 3);
      multiply_by(x, y, d);
      if (random.chance(2)) multiply_by(x, -2 * y, d % 4 == 0 ? d / 4 : d);
    }
    const auto [x, y] = std::pair(re, im);
    for (int k = 1; k < 24; ++k) {
      const Surd old = re;
      re = re * x - im * y;
      im = old * y + im * x;
    }
    CHECK(angle.half_turns().has_value() == im.is_zero());
    rational += im.is_zero() ? 1 : 0;
  });
  CHECK(rational > 5);
}

TEST_CASE("algebraic angle: numbers know whether they are rational, and sums do") {
  const auto number = [](const Rational& x, const Rational& y, const Rational& d) {
    return argument_value(arg(x, y, d), x, y, d);
  };
  const Real a = number(1, 1, 8);
  const Real b = number(-1, 2, 2);
  CHECK(a.origin().is_irrational);
  CHECK_FALSE(over_pi(a));
  CHECK(over_pi(a + b) == Rational(1));
  CHECK((a + b + to_real(Angle(-1, Rational(2, 5)))).exact() == Rational(2, 5));
  CHECK((a + -a).exact() == Rational(0));
  CHECK((a + Rational(-1) * a).exact() == Rational(0));
  const Real whole = a + b + to_real(Angle(1, 0));
  CHECK_FALSE(whole.exact());  // 2π, not 0
  CHECK(over_pi(whole) == Rational(2));
  CHECK(over_pi(-whole) == Rational(-2));
  const Real shifted = whole + Rational(1, 1000000);
  CHECK(shifted.origin().is_irrational);
  CHECK_FALSE(over_pi(shifted));
  CHECK((shifted + -whole).exact() == Rational(1, 1000000));
  CHECK_FALSE((whole + Real([](long) { return RealBall(); })).origin().is_irrational);
}
