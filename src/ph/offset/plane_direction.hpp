#pragma once
#include "phrame/algebra/rational.hpp"

namespace phrame::inline v0 {

/// A direction of the plane.
struct PlaneDirection {
  Rational x;  ///< its x
  Rational y;  ///< its y
  friend bool operator==(const PlaneDirection&, const PlaneDirection&) = default;
};
/// (e₁, n) turn to the right: n = (e₁y, −e₁x).
inline PlaneDirection right_normal(const PlaneDirection& e1) { return {e1.y, -e1.x}; }

/// > 0 where b is to the left of a.
inline Rational cross(const PlaneDirection& a, const PlaneDirection& b) {
  return a.x * b.y - a.y * b.x;
}

}  // namespace phrame
