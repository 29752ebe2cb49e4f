#pragma once
#include <string>

#include "phrame/answer/totals.hpp"

namespace phrame {

std::string to_text(const TotalsAnswer& answer);   ///< for reading, Unicode
std::string to_json(const TotalsAnswer& answer);   ///< totals/1, of a spline spline-totals/1
std::string to_latex(const TotalsAnswer& answer);  ///< for amsmath and amssymb

}  // namespace phrame
