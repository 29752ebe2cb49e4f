#include "phrame/answer/rounded.hpp"

#include <doctest/doctest.h>

#include "phrame/algebra/error.hpp"

using namespace phrame;

namespace {

/// 0, of which only balls are known.
Real unknown_zero() {
  return Real([](long bits) { return hull(-power_of_two(-bits), power_of_two(-bits), bits); });
}

}  // namespace

TEST_CASE("rounded: what cannot be told is named") {
  CHECK(rounded(Rational(2, 3), "the length", 5).value == "0.66667");
  try {
    rounded(unknown_zero(), "the length", 5);
    FAIL("a 0 that nothing tells from others was rounded");
  } catch (const Undecided& error) {
    CHECK(std::string(error.what()).starts_with("the length: "));
  }
}

TEST_CASE("rounded: a number that may be 0 is 0 within a bound") {
  const Decimal exact = rounded_or_zero(Rational(0), "error", 10);
  CHECK(exact.value == "0");
  CHECK(exact.radius == "0");
  const Decimal bounded = rounded_or_zero(unknown_zero(), "error", 10);
  CHECK(bounded.value == "0");
  // 14 bits a digit, and 128: 2⁻²⁶⁸ is 2.1e-81.
  CHECK(bounded.radius.find("e-8") != std::string::npos);
  CHECK(rounded_or_zero(Rational(2, 3), "error", 10, 3).value == "0.667");
}

TEST_CASE("rounded: the size of an error is a number or an upper bound") {
  const ErrorSize known = error_size(Rational(2, 3), "error", 10);
  CHECK(known.value.value == "0.6666666667");
  CHECK(known.in_short == "0.666667");
  CHECK_FALSE(known.is_bound);
  // Rounded once, not from the ten digits: 0.12345650000004… is 0.123457.
  CHECK(error_size(parse_rational("0.12345650000004"), "error", 10).in_short == "0.123457");
  CHECK_FALSE(error_size(Rational(0), "error", 10).is_bound);
  const ErrorSize bound = error_size(unknown_zero(), "error", 10);
  CHECK(bound.is_bound);
  CHECK(bound.value.value == bound.value.radius);
  CHECK(bound.in_short == "≤ " + bound.value.radius);
}

TEST_CASE("rounded: of an enclosure, the digits in which its ends agree") {
  const auto ball = [](const char* lower, const char* upper) {
    return hull(parse_rational(lower), parse_rational(upper), 256);
  };
  const auto value = [](const RealBall& x) { return rounded_as_known(x, 12).value; };
  CHECK(value(ball("0.12345678", "0.12345679")) == "0.1234568");
  CHECK(value(ball("-0.12345679", "-0.12345678")) == "-0.1234568");
  CHECK(value(ball("0.49999999999", "0.50000000001")) == "0.5000000000");
  CHECK(value(RealBall(Rational(1, 4), 64)) == "0.250000000000");
  CHECK(value(ball("-1e-20", "1e-30")) == "0");
  CHECK(value(RealBall(Rational(0), 64)) == "0");
  // No digit is known of what is between 1.4 and 1.6: its middle has one, and the radius is wide.
  const Decimal wide = rounded_as_known(ball("1.4", "1.6"), 12);
  CHECK(wide.value.size() == 1);
  CHECK(parse_rational(wide.radius) >= Rational(1, 2));
  CHECK(parse_rational(wide.radius) <= 1);
  // A quotient whose divisor may be 0, and one that is known with more bits.
  const RealBall none = divide(RealBall(Rational(1), 64), ball("-1", "1"), 64);
  CHECK_THROWS_AS(rounded_as_known(none, 12), Undecided);
  const Rational little = power_of_ten(-60);
  const Real seen([&](long bits) {
    const RealBall below = hull(little - power_of_two(-bits), little + power_of_two(-bits), bits);
    return divide(RealBall(little, bits), below, bits);
  });
  CHECK(rounded_as_known(seen, "a quotient", 12).value == "1.00000000000");
}
