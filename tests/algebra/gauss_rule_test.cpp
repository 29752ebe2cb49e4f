#include "phrame/algebra/gauss_rule.hpp"

#include <doctest/doctest.h>

#include "phrame/algebra/ball_order.hpp"
#include "phrame/algebra/ball_polynomial.hpp"

using namespace phrame;

TEST_CASE("gauss rule: law: n points integrate all powers below 2n, and not the next one") {
  constexpr long bits = 150;
  for (const long n : {1L, 2L, 3L, 8L, 21L}) {
    const GaussRule rule = gauss_rule(n, bits);
    REQUIRE(rule.points.size() == static_cast<std::size_t>(n));
    const auto integral = [&](long power) {
      RealBall sum;
      for (std::size_t k = 0; k < rule.points.size(); ++k)
        sum = add_product(sum, rule.weights[k], pow(rule.points[k], power, bits), bits);
      return sum;
    };
    for (long power = 0; power < 2 * n; ++power) {
      const Rational exact = power % 2 == 0 ? Rational(2, power + 1) : Rational(0);
      CHECK(integral(power).contains(exact));
      CHECK(is_at_most(radius_of(integral(power)), times_power_of_two(RealBall(1, 2), -130)));
    }
    CHECK_FALSE(integral(2 * n).contains(Rational(2, 2 * n + 1)));
    for (std::size_t k = 1; k < rule.points.size(); ++k)
      CHECK(is_less(rule.points[k - 1], rule.points[k]));
  }
}
