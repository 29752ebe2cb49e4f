#pragma once
#include <string>

#include "phrame/ph/curve/nearness.hpp"

namespace phrame::inline v0 {

/// "at most 5.3e-16 from it; rotation-minimizing frames differ by at most 2.1e-15": what a PH curve
/// is of the one in whose place it stands.
std::string to_line(const Nearness& nearness);

/// "no PH curve was found within 1e-15; the nearest one is 0.12 away"
std::string to_line(const NotNear& none, const Rational& epsilon);

/// "1e-15", "0.0125"; a bound of two digits of what has many.
std::string distance_text(const Rational& distance);

}  // namespace phrame
