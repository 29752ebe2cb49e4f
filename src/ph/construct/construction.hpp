#pragma once
#include "phrame/ph/construct/quintic_family.hpp"
#include "phrame/ph/curve/path.hpp"

namespace phrame {

/// How far a curve may be from its data, and how far it is.
struct Deviation {
  Rational points;
  Rational derivatives;
  friend bool operator==(const Deviation&, const Deviation&) = default;
};

/// An exact curve near its data.
struct Construction {
  Path path;
  std::vector<Rational> parameters;  ///< of the joints and the ends, those of the data
  std::vector<FreeAngles> angles;    ///< chosen for each segment
  /// The coefficients of A are multiples of 2^−bits; but not those of what closes a spline.
  long bits;
  Deviation deviation;  ///< proved: not less than the greatest distances from the data
};

}  // namespace phrame
