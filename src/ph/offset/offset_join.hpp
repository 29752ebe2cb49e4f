#pragma once
#include <vector>

#include "phrame/ph/offset/offset.hpp"
#include "phrame/ph/offset/plane_tangent.hpp"

namespace phrame::inline v0 {

/// A corner of a plane path, seen along e₁.
struct PlaneCorner {
  Vector<Rational> at;    ///< where it is
  PlaneDirection before;  ///< e₁ where the path comes to it
  PlaneDirection after;   ///< e₁ where it goes on, not parallel to that
  int sign;               ///< 1 where e₁ is r′/|r′|, −1 where it is the opposite
};

/// Is the offset to the right of e₁ by d on the outer side of the corner, where the offsets of both
/// sides are apart?
bool is_outside(const PlaneCorner& corner, const Rational& d);

/// What joins the offsets there, from at + d·n before to at + d·n after, with H along e₁: arcs of
/// less than 2π/3, rational quadratics, each point of which is at the distance |d| from the corner;
/// or two straight lines; or nothing. Precondition: is_outside().
std::vector<RationalCurve> corner_join(const PlaneCorner& corner, const Rational& d,
                                       OffsetJoin join);

/// The arc of a circle from center + radius·a to the left to center + radius·b, of unit vectors, in
/// quarters and what is left of the last one; where a = b, all of the circle.
std::vector<RationalCurve> circle_arcs(const Vector<Rational>& center, PlaneDirection a,
                                       const PlaneDirection& b, const Rational& radius);

/// The half-circle about the end of a path, from at + d·n around it to at − d·n: ahead of it, which
/// is along e₁ for a sign > 0 and against it else.
std::vector<RationalCurve> end_cap(const Vector<Rational>& at, const PlaneDirection& e1, int sign,
                                   const Rational& d);

}  // namespace phrame
