#pragma once
#include <array>

#include "phrame/algebra/rounding.hpp"
#include "phrame/ph/curve/rational_curve.hpp"

namespace phrame::inline v0 {

/// An end of a part of a trimmed offset or envelope.
struct BoundaryEnd {
  Real t;                     ///< of the path, exact where that is known to be rational
  Decimal rounded;            ///< to the digits asked for
  std::array<Decimal, 2> at;  ///< x and y
};
/// Where a curve has the parameter t, and the path another one.
BoundaryEnd boundary_end(const RationalCurve& curve, const Real& t, const Real& of_path,
                         long digits);
/// With 12 digits, and a radius.
Decimal decimal_of(const RealBall& x);
/// To the digits asked for; where no enclosure is narrow, as of a cut that is undecided, as above.
Decimal rounded_as_known(const Real& x, const std::string& name, long digits);

}  // namespace phrame
