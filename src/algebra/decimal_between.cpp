#include "phrame/algebra/decimal_between.hpp"

#include "phrame/algebra/rounding.hpp"

namespace phrame::inline v0 {
namespace {

/// A bound on the side of `direction`.
std::string bound(const Rational& x, int direction) {
  const bool is_outward = (x > 0) == (direction > 0);
  const Rational size = abs(x);
  return (x < 0 ? "-" : "") + (is_outward ? upper_bound_text(size) : lower_bound_text(size));
}

}  // namespace

std::string decimal_between(const Rational& lower, const Rational& upper, long digits) {
  for (; digits > 0; --digits) {
    std::string text = round_to_decimal(lower, digits).value;
    if (text == round_to_decimal(upper, digits).value) return text;
  }
  return bound(lower, -1) + " to " + bound(upper, 1);
}

Rational half_unit(const Rational& value, long digits) {
  return 5 * power_of_ten((value == 0 ? -1 : decimal_exponent(abs(value))) - digits);
}

}  // namespace phrame
