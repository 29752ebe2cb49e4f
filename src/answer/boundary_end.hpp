#pragma once
#include <array>

#include "phrame/algebra/rounding.hpp"

namespace phrame::inline v0 {

/// An end of a part of a trimmed offset or envelope.
struct BoundaryEnd {
  Real t;                     ///< of the path, exact where that is known to be rational
  Real share;                 ///< the parameter of the piece, from 0 to 1
  Decimal rounded;            ///< t to the digits asked for
  std::array<Decimal, 2> at;  ///< x and y
};

}  // namespace phrame
