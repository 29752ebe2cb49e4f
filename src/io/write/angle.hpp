#pragma once
#include <string>

#include "phrame/answer/angle.hpp"

namespace phrame {

std::string to_text(const AngleAnswer& answer);       ///< for reading, Unicode
std::string to_latex(const AngleAnswer& answer);      ///< the closed form and the table
std::string to_json(const AngleAnswer& answer);       ///< angle/1, of a spline spline-angle/1
std::string to_json_line(const AngleAnswer& answer);  ///< the same on one line, without its end

/// "t  θ(t)", a line each; long t are passages.
std::string value_table(const std::vector<AngleValue>& values, long digits);
/// The same for LaTeX.
std::string latex_value_table(const std::vector<AngleValue>& values);

}  // namespace phrame
