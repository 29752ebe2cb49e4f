#pragma once
#include <string>

#include "phrame/answer/classification.hpp"

namespace phrame {

std::string to_text(const ClassificationAnswer& answer);  ///< for reading, Unicode
/// classify/1, of a spline spline-classify/1
std::string to_json(const ClassificationAnswer& answer);
std::string to_latex(const ClassificationAnswer& answer);  ///< for amsmath and amssymb

}  // namespace phrame
