#pragma once
#include <string_view>

#include "phrame/algebra/angle.hpp"

namespace phrame::inline v0 {

/// Reads an angle, exactly: radians ("0.3927", "-3/7"), a multiple of π ("pi/8", "-31pi/40",
/// "0.125pi", "5/8*pi", "π") or degrees ("45deg", "-22.5°"); blanks around these parts do not
/// matter. One division at most: of "pi/4/2" it is not sure what is meant. Throws InputError (no
/// place) on anything else.
Angle parse_angle(std::string_view text);

}  // namespace phrame
