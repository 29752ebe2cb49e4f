#pragma once
#include <array>

#include "phrame/algebra/ball.hpp"

namespace phrame::inline v0 {

/// A box in the plane.
using PlaneBall = std::array<RealBall, 2>;

/// @{ Of vectors, with so many bits.
inline RealBall dot(const PlaneBall& a, const PlaneBall& b, long bits) {
  return add_product(multiply(a[0], b[0], bits), a[1], b[1], bits);
}
inline RealBall cross(const PlaneBall& a, const PlaneBall& b, long bits) {
  return subtract(multiply(a[0], b[1], bits), multiply(a[1], b[0], bits), bits);
}
inline PlaneBall difference(const PlaneBall& a, const PlaneBall& b, long bits) {
  return {subtract(a[0], b[0], bits), subtract(a[1], b[1], bits)};
}
/// @}

}  // namespace phrame
