#include "phrame/ph/proof/stated_number.hpp"

#include <algorithm>

#include "phrame/algebra/decimal_between.hpp"
#include "phrame/algebra/rounding.hpp"

namespace phrame::inline v0 {

StatedNumber stated_number(const Real& x, long digits, bool is_found_exactly, long spare) {
  StatedNumber stated{round_to_decimal(x, digits).value, "0", 0};
  const Rational value = parse_rational(stated.value);
  Rational radius = half_unit(value, digits);
  const std::optional<Rational>& exact = x.exact();
  const auto set_radius = [&] { stated.radius = upper_bound_text(radius, 1); };
  if (is_found_exactly) {
    if (*exact != value) set_radius();
    return stated;
  }
  if (exact && abs(*exact - value) == radius) radius *= 2;
  set_radius();
  for (stated.slack = radius * power_of_two(-spare);; stated.slack *= power_of_two(-64)) {
    const RealBall enclosure = x.enclose(2 - binary_exponent(stated.slack));
    const Rational off = std::max(abs(enclosure.upper() - value), abs(enclosure.lower() - value));
    if (off + 4 * stated.slack <= radius) return stated;
  }
}

}  // namespace phrame
