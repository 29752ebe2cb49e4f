#pragma once
#include <string>

#include "phrame/algebra/real.hpp"

namespace phrame::inline v0 {

/// Half a unit of the last of so many significant digits of the value that x is rounded to, or a
/// whole one where x is known to be half way between two decimals.
Rational rounding_radius(const Real& x, const Rational& value, long digits);

/// A number as a certificate states it: |x − value| ≤ radius.
struct StatedNumber {
  std::string value;   ///< a decimal, correctly rounded
  std::string radius;  ///< a decimal, mostly half a unit of the last digit of the value
  Rational slack;      ///< what the x that a proof finds may be off; 0 where x is known exactly
};

/// x with `digits` significant digits; the slack is 2^−spare of the radius, or less where x lies
/// nearly half way between two decimals. Where a proof finds x itself the radius is 0 for a value
/// that is x. Where it does not, an x half way between two decimals gets a whole unit.
StatedNumber stated_number(const Real& x, long digits, bool is_found_exactly, long spare);

}  // namespace phrame
