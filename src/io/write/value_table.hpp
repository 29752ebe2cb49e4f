#pragma once
#include <string>
#include <vector>

#include "phrame/answer/angle.hpp"

namespace phrame {

/// "t  θ(t)", a line each; long t are passages.
std::string value_table(const std::vector<AngleValue>& values, long digits);
/// The same for LaTeX.
std::string latex_value_table(const std::vector<AngleValue>& values);

}  // namespace phrame
