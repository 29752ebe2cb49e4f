#pragma once
#include <string>

#include "phrame/ph/construct/nearness.hpp"

namespace phrame {

/// "at most 5.3e-16 from it; rotation-minimizing frames differ by at most 2.1e-15": what a PH curve
/// is of the one in whose place it stands.
std::string to_line(const Nearness& nearness);

}  // namespace phrame
