#pragma once
#include "phrame/algebra/ball.hpp"

namespace phrame::inline v0 {

/// A real ball as a number of a ring, for templates that are written for any: its operations are
/// add, subtract and multiply with so many bits.
template <long bits>
struct RingBall {
  RealBall x;
  friend RingBall operator+(const RingBall& a, const RingBall& b) { return {add(a.x, b.x, bits)}; }
  friend RingBall operator-(const RingBall& a, const RingBall& b) {
    return {subtract(a.x, b.x, bits)};
  }
  friend RingBall operator*(const RingBall& a, const RingBall& b) {
    return {multiply(a.x, b.x, bits)};
  }
};

}  // namespace phrame
