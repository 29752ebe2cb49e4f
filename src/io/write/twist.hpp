#pragma once
#include <string>

#include "phrame/answer/minimal_twist.hpp"

namespace phrame {

std::string to_text(const MinimalTwistAnswer& answer);   ///< for reading, Unicode
std::string to_json(const MinimalTwistAnswer& answer);   ///< mtf/1
std::string to_latex(const MinimalTwistAnswer& answer);  ///< for amsmath and amssymb

}  // namespace phrame
