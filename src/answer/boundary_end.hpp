#pragma once
#include <array>

#include "phrame/algebra/rounding.hpp"

namespace phrame::inline v0 {

/// An end of a part of a trimmed offset or envelope.
struct BoundaryEnd {
  Real t;                     ///< of the path, exact where that is known to be rational
  Decimal rounded;            ///< to the digits asked for
  std::array<Decimal, 2> at;  ///< x and y
};

}  // namespace phrame
