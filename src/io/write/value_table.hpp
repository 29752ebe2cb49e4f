#pragma once
#include <string>
#include <vector>

#include "phrame/answer/angle.hpp"

namespace phrame::inline v0 {

/// "t  θ(t)", a line each, behind the parameter that was asked by, where that is another; long t
/// are passages.
std::string value_table(const std::vector<AngleValue>& values, long digits, ParameterKind by);
/// The same for LaTeX.
std::string latex_value_table(const std::vector<AngleValue>& values, ParameterKind by);

}  // namespace phrame
