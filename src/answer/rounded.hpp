#pragma once
#include <string>

#include "phrame/algebra/rounding.hpp"
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

/// A number that is not negative: correctly rounded, or, where it may be 0, an upper bound.
struct ErrorSize {
  Decimal value;          ///< with the digits asked for
  std::string in_short;   ///< the number, rounded once to six digits for a table
  bool is_bound = false;  ///< is it an upper bound?
};
/// Of a number ≥ 0.
ErrorSize error_size(const Real& number, const std::string& name, long digits);

}  // namespace phrame
