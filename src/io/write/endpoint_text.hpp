#pragma once
#include <string>

#include "phrame/integrate/path_end.hpp"

namespace phrame::inline v0 {

/// "3/7", "−∞", "√2", "the root of x³ − 2 in (1, 2)", "(2/3)π".
std::string to_text(const PathEnd& end);
/// The same; there is no room for a polynomial of a degree > 2: "\approx 1.2599210".
std::string to_latex(const PathEnd& end);

}  // namespace phrame
