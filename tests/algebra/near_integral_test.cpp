#include "phrame/algebra/near_integral.hpp"

#include <random>

#include <doctest/doctest.h>

#include "phrame/algebra/ball_log.hpp"
#include "phrame/algebra/elementary.hpp"
#include "phrame/algebra/gauss_rule.hpp"
#include "phrame/algebra/near_gauss_rule.hpp"
#include "phrame/algebra/rounding.hpp"
#include "phrame/integrate/taylor_integral.hpp"

using namespace phrame;

namespace {

constexpr long bits = 200;

std::optional<RealBall> near(const RootQuotient& f) {
  return near_integral(unit_quotient(f.numerator, f.denominator, f.radicand));
}

/// The same by Taylor series, which are asked for more bits than doubles have.
RealBall by_series(const RootQuotient& f) { return TaylorIntegral(f).enclose(Rational(1), bits); }

bool contains(const RealBall& ball, const RealBall& number) {
  return ball.lower() <= number.lower() && number.upper() <= ball.upper();
}

}  // namespace

// asinh 1 = log(1 + √2), and 1/((1 + t²)√(2 + t²)) is the derivative of arctan(t/√(2 + t²)).
TEST_CASE("near integral: logarithms and arcs in closed form") {
  const auto logarithm = near({{1}, {1}, {1, 0, 1}});
  REQUIRE(logarithm);
  const RealBall root = sqrt(RealBall(2, bits), bits);
  CHECK(contains(*logarithm, log(add(RealBall(1, bits), root, bits), bits)));
  CHECK(logarithm->is_accurate(87));
  for (const long sign : {1L, -1L}) {
    const auto sixth = near({{sign}, Polynomial{sign, 0, sign}, {2, 0, 1}});
    REQUIRE(sixth);
    CHECK(contains(*sixth, divide(pi(bits), RealBall(6, bits), bits)));
    CHECK(sixth->is_accurate(87));
    const auto other = near({{-6 * sign}, Polynomial{sign, 0, sign}, {2, 0, 1}});
    REQUIRE(other);
    CHECK(contains(subtract(RealBall(), *other, 256), pi(bits)));
  }
}

TEST_CASE("near integral: random quotients, as Taylor series have them") {
  std::mt19937 random(17);
  const auto number = [&](long most) {
    return std::uniform_int_distribution<long>(-most, most)(random);
  };
  int proved = 0;
  for (int n = 0; n < 60; ++n) {
    CAPTURE(n);
    const long most = n % 3 == 0 ? 9 : n % 3 == 1 ? 1'000'000 : 1L << 50;
    const auto square = [&] {  // the sum of two squares, which are seldom 0 at once
      const Polynomial p{number(most), number(most), number(most)};
      const Polynomial q{number(most), number(most), number(most)};
      return p * p + q * q;
    };
    const RootQuotient f{Polynomial{number(most), number(most), number(most), number(most)},
                         square(), square()};
    const auto found = near(f);
    if (!found) continue;
    ++proved;
    CHECK(contains(*found, by_series(f)));
  }
  CHECK(proved > 40);
}

TEST_CASE("near integral: what has a zero on the way, or too near, is left to others") {
  CHECK_FALSE(near({{1}, {-1, 2}, {1, 0, 1}}));         // D = 0 at 1/2
  CHECK_FALSE(near({{1}, {1}, {-1, 3}}));               // S = 0 at 1/3
  CHECK_FALSE(near({{1}, {1}, {-1}}));                  // S < 0
  CHECK_FALSE(near({{1}, {0, 1}, {1, 0, 1}}));          // D = 0 at 0
  CHECK_FALSE(near({{1}, {1}, {1, -1}}));               // S = 0 at 1
  CHECK_FALSE(near({{1}, Polynomial{1, -4, 4}, {1}}));  // D = (1 − 2t)²
  CHECK_FALSE(near({{1}, Polynomial{1 + power_of_two(-200), -4, 4}, {1, 0, 1}}));
  CHECK_FALSE(near({{}, {1}, {1, 0, 1}}));
}

// Zeros at 1/3 ± 2^−k·i, up to where there would be too many parts.
TEST_CASE("near integral: zeros near the path are made up for by short parts") {
  for (long k = 0; k < 24; k += 3) {
    CAPTURE(k);
    const Polynomial near_zero =
        Polynomial{-1, 3} * Polynomial{-1, 3} + Polynomial{9 * power_of_two(-2 * k)};
    for (const RootQuotient& f :
         {RootQuotient{{1, 2, 3}, near_zero, {1, 0, 1}}, RootQuotient{{1, 2, 3}, {1}, near_zero}}) {
      const auto found = near(f);
      REQUIRE(found);
      CHECK(contains(*found, by_series(f)));
      CHECK(found->is_accurate(87));
    }
  }
}

// Where M is great, an ellipse is of no use.
TEST_CASE("near integral: zeros of high order just outside of an ellipse") {
  for (long k = 28; k < 50; ++k) {
    CAPTURE(k);
    const RootQuotient f{
        {1}, pow(Polynomial{Rational(1, 4) + Rational(k * k, 10000), -1, 1}, 8), {1, 0, 1}};
    if (const auto found = near(f)) CHECK(contains(*found, by_series(f)));
  }
  CHECK(near({{1}, pow(Polynomial{1, -1, 1}, 8), {1, 0, 1}}));
}

TEST_CASE("near integral: the points and weights of the rule, as balls have them") {
  const std::size_t half = near_gauss_rule.size();
  const GaussRule rule = gauss_rule(static_cast<long>(2 * half), bits);
  const auto is_near = [](const RealBall& number, double high, double low) {
    const RealBall off = subtract(number, exact_sum(high, low), bits);
    return contains(widened(RealBall(), 0x1p-106), off);
  };
  for (std::size_t k = 0; k < half; ++k) {
    CAPTURE(k);
    const auto& [high, low, weight_high, weight_low] = near_gauss_rule[k];
    CHECK(is_near(rule.points[half + k], high, low));
    CHECK(is_near(rule.points[half - 1 - k], -high, -low));
    CHECK(is_near(rule.weights[half + k], weight_high, weight_low));
  }
}
