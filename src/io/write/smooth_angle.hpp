#pragma once
#include <string>

#include "phrame/answer/smooth_angle.hpp"

namespace phrame {

std::string to_text(const SmoothAngleAnswer& answer);       ///< for reading, Unicode
std::string to_latex(const SmoothAngleAnswer& answer);      ///< the integral and the table
std::string to_json(const SmoothAngleAnswer& answer);       ///< angle/1, of a path spline-angle/1
std::string to_json_line(const SmoothAngleAnswer& answer);  ///< the same, without its end

}  // namespace phrame
