#pragma once
#include <string>

#include "phrame/algebra/rounding.hpp"

namespace phrame::inline v0 {

/// A number that is not negative: correctly rounded, or, where it may be 0, an upper bound.
struct ErrorSize {
  Decimal value;          ///< with the digits asked for
  std::string in_short;   ///< the number, rounded once to six digits for a table
  bool is_bound = false;  ///< is it an upper bound?
};

}  // namespace phrame
