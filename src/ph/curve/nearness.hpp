#pragma once
#include <optional>

#include "phrame/algebra/rational.hpp"

namespace phrame::inline v0 {

/// How near an exact PH curve or spline is to a given one, of the same degrees and with the same
/// parameter.
struct Nearness {
  /// No control point is farther from that of the given curve, hence no point of the curve (convex
  /// hull). Proved, by fractions.
  Rational distance;
  /// The same of the PH curve that was rounded to the fewest bits: how far the given one is from
  /// being PH, as far as was found.
  Rational unrounded_distance;
  long bits;  ///< the Bernstein coefficients of A, as they were found, are multiples of 2^−bits
  /// A bound, proved, of the angle between the rotation-minimizing frames of both, which agree at t
  /// = 0 (rmf_difference_bound). No value where the speed is not kept from 0.
  std::optional<Rational> rmf_difference;
  Rational epsilon;  ///< that was allowed for the distance
};

/// None was found that is near enough.
struct NotNear {
  /// Of the nearest that was found; no value where those near the segments do not join smoothly.
  std::optional<Rational> distance = {};
};

}  // namespace phrame
