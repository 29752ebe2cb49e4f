#pragma once
#include <string>

#include "phrame/answer/info.hpp"

namespace phrame {

/// @{ For reading, Unicode.
std::string to_text(const InfoAnswer& info);
std::string to_text(const SmoothInfoAnswer& info);
/// @}
/// @{ info/1, of a spline spline-info/1.
std::string to_json(const InfoAnswer& info);
std::string to_json(const SmoothInfoAnswer& info);
/// @}
/// @{ For amsmath and amssymb.
std::string to_latex(const InfoAnswer& info);
std::string to_latex(const SmoothInfoAnswer& info);
/// @}

}  // namespace phrame
