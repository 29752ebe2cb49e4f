#pragma once
#include <string>

#include "phrame/algebra/rational.hpp"

namespace phrame::inline v0 {

/// What is known of a number between the two, as a decimal without a wrong digit: the one with so
/// many significant digits, or fewer, to which both round. "0.25"; "0.2 to 0.3", bounds, where not
/// even one digit is common to both.
std::string decimal_between(const Rational& lower, const Rational& upper, long digits);

/// Half a unit in the last place of a decimal with so many significant digits.
Rational half_unit(const Rational& value, long digits);

}  // namespace phrame
