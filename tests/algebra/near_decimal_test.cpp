#include "phrame/algebra/near_decimal.hpp"

#include <fmt/format.h>

#include "phrame/algebra/near_arithmetic.hpp"
#include "phrame/algebra/rational.hpp"
#include "phrame/algebra/rounding.hpp"
#include "support/doubles.hpp"

using namespace phrame;

namespace near_decimal_test {

using test::for_samples;
using test::Random;

Rational exact(const NearNumber& x) {
  return exact_rational(x.value.high) + exact_rational(x.value.low);
}

Rational off(const NearNumber& x, const Rational& from) { return abs(exact(x) - from); }

/// What is read is within the error, and that is small.
void check_decimal(const std::string& text) {
  CAPTURE(text);
  const auto found = near_decimal(text);
  REQUIRE(found.has_value());
  const Rational x = parse_rational(text);
  CHECK(off(*found, x) <= exact_rational(found->error));
  CHECK(exact_rational(found->error) <= abs(x) * power_of_two(-95));
  CHECK(found->value.high == round_to_double(x));
}

std::string digits(Random& random, long count) {
  std::string text;
  for (long k = 0; k < count; ++k)
    text += std::to_string(random.chance(3) ? 0 : random.integer(0, 9));
  return text;
}

/// A number, near.
NearNumber any_near(Random& random, Rational& exactly) {
  const double high = test::any_double(random);
  const double low = high * 0x1p-54 * static_cast<double>(random.integer(-9, 9)) / 10;
  const double error = random.chance(3) ? 0 : std::abs(high) * 0x1p-80;
  exactly = exact_rational(high) + exact_rational(low) +
            exact_rational(error) * Rational(random.integer(-10, 10), 10);
  return within({high, low}, error);
}

void check_bounds(const NearBounds& bounds, const Rational& x) {
  CHECK(exact_rational(bounds.lower) <= abs(x));
  CHECK(abs(x) <= exact_rational(bounds.upper));
}

}  // namespace near_decimal_test

using namespace near_decimal_test;

TEST_CASE("near decimal: law: it is what parse_rational reads, within the error") {
  for (const char* text :
       {"0.1", "-12", "+3.25", ".5", "7.", "1e-3", "-1.5E+12", "0.0001", "123456789012345678",
        "18446744073709551615", "9999999999999999999", "99999999999999999999999999999999999999",
        "0.7071067811865475244008443621048490392848359376884740365883398689", "1e22",
        "0.0000000000000000000000000000123456789012345678901234567890", "1e-250",
        "2.2204460492503131e-16", "1.5E-3", "9007199254740993"})
    check_decimal(text);
  for_samples(300, [](Random& random) {
    std::string text =
        digits(random, random.integer(1, 30)) + "." + digits(random, random.integer(0, 30));
    if (random.chance(2)) text += fmt::format("e{}", random.integer(-99, 99));
    check_decimal("1" + text);
    check_decimal("-0" + text);
  });
}

TEST_CASE("near decimal: what is a double of few digits is exact") {
  for (const auto& [text, value] :
       {std::pair("0.5", 0.5), std::pair("1.000000000000000000e+00", 1.0),
        std::pair("0.100000e1", 1.0), std::pair("-00.125000", -0.125), std::pair("-0.0", 0.0)}) {
    CAPTURE(text);
    const auto found = near_decimal(text);
    REQUIRE(found.has_value());
    CHECK(found->value.high == value);
    CHECK(found->value.low == 0);
    CHECK(found->error == 0);
  }
}

TEST_CASE("near decimal: anything else has no value") {
  for (const char* text : {"", "-", ".", "e5", "1e", "1e+", "3/7", "nan", "inf", "0x1p-3", "1 2",
                           "1,5", "--1", "1e5.0", "1e-280", "1e271", "1e99999", "1.2.3", "1f"}) {
    CAPTURE(text);
    CHECK_FALSE(near_decimal(text).has_value());
  }
}

TEST_CASE("near arithmetic: law: sums, products and bounds hold the exact ones") {
  for_samples(500, [](Random& random) {
    Rational x, y;
    const NearNumber a = any_near(random, x);
    const NearNumber b = any_near(random, y);
    const auto holds = [](const NearNumber& found, const Rational& wanted) {
      CHECK(off(found, wanted) <= exact_rational(raised(found.error)));
    };
    holds(a + b, x + y);
    holds(a - b, x - y);
    holds(a * b, x * y);
    check_bounds(size_bounds(a), x);
    check_bounds(product(size_bounds(a), size_bounds(b)), x * y);
    const NearBounds of_root = root(size_bounds(a));
    CHECK(exact_rational(of_root.lower) * exact_rational(of_root.lower) <= abs(x));
    CHECK(abs(x) <= exact_rational(of_root.upper) * exact_rational(of_root.upper));
    if (y != 0 && size_bounds(b).lower > 0)
      check_bounds(quotient(size_bounds(a), size_bounds(b)), x / y);
    if (is_positive(a)) CHECK(x > 0);
  });
}
