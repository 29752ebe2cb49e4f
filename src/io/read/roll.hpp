#pragma once
#include <string_view>

#include "phrame/export.hpp"
#include "phrame/ph/curve/roll.hpp"

namespace phrame::inline v0 {

/// Reads a roll as it is typed: an angle, "pi/4" or "15deg", a rational function of t in radians,
/// "t^2/3", or in degrees, "30*t deg", or angles at t = 0, 1, … with commas between them,
/// "0,15deg,pi/4". Throws InputError as
/// parse_expression and parse_angle.
PHRAME_API Roll parse_roll(std::string_view text);

}  // namespace phrame
