#include "phrame/ph/proof/stated_number.hpp"

#include <algorithm>

#include "phrame/algebra/decimal_between.hpp"
#include "phrame/algebra/rounding.hpp"

namespace phrame::inline v0 {

Rational rounding_radius(const Real& x, const Rational& value, long digits) {
  const Rational half = half_unit(value, digits);
  const std::optional<Rational>& exact = x.exact();
  return exact && abs(*exact - value) == half ? 2 * half : half;
}

StatedNumber stated_number(const Real& x, long digits, bool is_found_exactly, long spare) {
  StatedNumber stated{round_to_decimal(x, digits).value, "0", 0};
  const Rational value = parse_rational(stated.value);
  if (is_found_exactly) {
    if (*x.exact() != value) stated.radius = upper_bound_text(half_unit(value, digits), 1);
    return stated;
  }
  const Rational radius = rounding_radius(x, value, digits);
  stated.radius = upper_bound_text(radius, 1);
  for (stated.slack = radius * power_of_two(-spare);; stated.slack *= power_of_two(-64)) {
    const RealBall enclosure = x.enclose(2 - binary_exponent(stated.slack));
    const Rational off = std::max(abs(enclosure.upper() - value), abs(enclosure.lower() - value));
    if (off + 4 * stated.slack <= radius) return stated;
  }
}

}  // namespace phrame
