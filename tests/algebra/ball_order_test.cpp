#include "phrame/algebra/ball_order.hpp"

#include "phrame/algebra/rounding.hpp"
#include "support/random.hpp"

namespace ball_order_test {

using namespace phrame;
using test::for_samples;
using test::Random;

namespace {

constexpr long bits = 80;

/// All numbers of a ball.
struct BallInterval {
  RealBall ball;
  Rational from = ball.lower();
  Rational to = ball.upper();
};

BallInterval random_interval(Random& random) {
  const Rational from(random.integer(-40, 40), 8);
  const Rational to = from + Rational(random.chance(3) ? 0 : random.integer(0, 20), 8);
  return {hull(from, to, bits)};
}

/// Is the ball [from, to] up to the rounding of its radius?
bool is_around(const RealBall& ball, const Rational& from, const Rational& to) {
  const Rational slack = power_of_two(-20);
  return ball.lower() <= from && from - slack <= ball.lower() && to <= ball.upper() &&
         ball.upper() <= to + slack;
}

}  // namespace

TEST_CASE("ball order: law: less is what all numbers of one are than all of the other") {
  for_samples(300, [](Random& random) {
    const BallInterval a = random_interval(random);
    const BallInterval b = random_interval(random);
    CHECK(is_less(a.ball, b.ball) == (a.to < b.from));
    CHECK(is_at_most(a.ball, b.ball) == (a.to <= b.from));
    CHECK(is_around(max(a.ball, b.ball, bits), std::max(a.from, b.from), std::max(a.to, b.to)));
    CHECK(is_around(min(a.ball, b.ball, bits), std::min(a.from, b.from), std::min(a.to, b.to)));
  });
  CHECK_FALSE(is_less(RealBall::unknown(), RealBall(1, bits)));
  CHECK_FALSE(is_at_most(RealBall(1, bits), RealBall::unknown()));
}

TEST_CASE("ball order: law: ends, sizes and exponents") {
  for_samples(300, [](Random& random) {
    const BallInterval a = random_interval(random);
    const RealBall& ball = a.ball;
    CHECK(lower_end(ball, bits).lower() == a.from);
    CHECK(lower_end(ball, bits).radius() == 0);
    const bool has_zero = a.from <= 0 && a.to >= 0;
    const Rational least = has_zero ? Rational(0) : std::min(abs(a.from), abs(a.to));
    const Rational greatest = std::max(abs(a.from), abs(a.to));
    CHECK(least_size(ball, bits).midpoint() == least);
    CHECK(radius_of(ball).midpoint() == (a.to - a.from) / 2);
    CHECK(radius_of(ball).radius() == 0);
    if (greatest == 0) {
      CHECK(exponent_above(ball) == -unbounded_exponent);
    } else {
      CHECK(greatest < power_of_two(exponent_above(ball)));
      CHECK(power_of_two(exponent_above(ball) - 2) <= greatest);
    }
    if (least == 0) {
      CHECK(exponent_below(ball) == -unbounded_exponent);
    } else {
      CHECK(least >= power_of_two(exponent_below(ball)));
      CHECK(power_of_two(exponent_below(ball) + 2) > least);
    }
  });
  CHECK(exponent_above(RealBall::unknown()) == unbounded_exponent);
}

TEST_CASE("ball order: law: an integer is named where it is the only one") {
  for_samples(300, [](Random& random) {
    const BallInterval a = random_interval(random);
    const Integer last = floor(a.to);
    const Integer first = -floor(-a.from);
    CHECK(contains_integer(a.ball) == (first <= last));
    CHECK(unique_integer(a.ball) == (first == last ? std::optional(first) : std::nullopt));
    const Integer ceiling = -floor(-a.to);
    const auto found = unique_ceiling(a.ball, bits);
    if (found) CHECK((*found == first && first == ceiling));
    const Rational slack = power_of_two(-20);
    if (a.from - slack > first - 1 && a.to + slack < first) CHECK(found);
  });
  CHECK_FALSE(unique_integer(RealBall::unknown()));
  const Integer large = pow(Integer(10), 40);
  CHECK(unique_integer(RealBall(Rational(large), 200)) == large);
}

}  // namespace ball_order_test
