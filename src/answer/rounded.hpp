#pragma once
#include <string>

#include "phrame/algebra/rounding.hpp"

namespace phrame {

/// round_to_decimal; where that is undecided, the message begins with what the number is.
Decimal rounded(const Real& x, const std::string& name, long digits);

}  // namespace phrame
