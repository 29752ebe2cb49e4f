#pragma once
#include <string>

#include "phrame/answer/info.hpp"

namespace phrame {

std::string to_text(const InfoAnswer& info);   ///< for reading, Unicode
std::string to_json(const InfoAnswer& info);   ///< info/1, of a spline spline-info/1
std::string to_latex(const InfoAnswer& info);  ///< for amsmath and amssymb

}  // namespace phrame
