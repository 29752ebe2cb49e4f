#pragma once
#include <string>

#include "phrame/algebra/rounding.hpp"

namespace phrame::inline v0 {

/// The integer next to x·10^places, half to even: x correctly rounded to so many decimals. 0 is no
/// boundary here. Throws Undecided as round_to_double().
Integer round_to_places(const Real& x, long places, PrecisionLimit limit = {});

/// n/10^places with exactly so many decimals, "-0.0500", or "-3" for 0 places; 0 has no sign.
std::string fixed_point_text(const Integer& n, long places);

}  // namespace phrame
