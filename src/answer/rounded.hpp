#pragma once
#include <string>

#include "phrame/answer/error_size.hpp"
#include "phrame/ph/along/path_totals.hpp"

namespace phrame {

/// round_to_decimal; where that is undecided, the message begins with what the number is.
Decimal rounded(const Real& x, const std::string& name, long digits);

/// The same; what is not in closed form as the number that may be 0.
Decimal rounded(const PathTotal& total, const std::string& name, long digits);

/// @{ The same of a number that may be 0: where it cannot be told from 0, 0 with the radius that is
/// known, by a precision for `digits`; with `shown_digits` ≤ digits.
Decimal rounded_or_zero(const Real& x, const std::string& name, long digits, long shown_digits);
Decimal rounded_or_zero(const Real& x, const std::string& name, long digits);
/// @}

/// The size of a number ≥ 0.
ErrorSize error_size(const Real& number, const std::string& name, long digits);

}  // namespace phrame
