#pragma once
#include <vector>

#include "phrame/ph/curve/quaternion.hpp"

namespace phrame::inline v0 {

/// The Bézier curve Σ B_k w_k P_k / Σ B_k w_k on [0, 1], B_k the Bernstein polynomials of degree n.
struct RationalBezier {
  std::vector<Vector<Rational>> points;  ///< n + 1
  std::vector<Rational> weights = {};    ///< n + 1 numbers > 0; none: all are 1

  friend bool operator==(const RationalBezier&, const RationalBezier&) = default;
};

}  // namespace phrame
