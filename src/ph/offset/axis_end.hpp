#pragma once
#include "phrame/ph/offset/envelope.hpp"

namespace phrame::inline v0 {

/// An end of a segment: a disc, and where the sides of the envelope touch it.
struct AxisEnd {
  Vector<Rational> disc;  ///< its center and radius
  PlaneDirection right;   ///< n on the side that is to the right of travel there
  PlaneDirection left;
  int grows;  ///< where right = left, 1 where the radius grows
  friend bool operator==(const AxisEnd&, const AxisEnd&) = default;
};
/// At t = 0 or 1.
AxisEnd end_of(const MinkowskiCurve& curve, const Rational& t);

}  // namespace phrame
