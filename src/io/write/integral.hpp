#pragma once
#include <string>

#include "phrame/answer/integral.hpp"

namespace phrame {

/// For reading, Unicode. Is it said that the derivative was checked? (It always was.)
std::string to_text(const IntegralAnswer& answer, bool says_checked = true);
std::string to_latex(const IntegralAnswer& answer);  ///< the closed form and the value
std::string to_json(const IntegralAnswer& answer);   ///< integral/1

}  // namespace phrame
