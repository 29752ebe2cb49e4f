#pragma once
#include "phrame/ph/construct/construction.hpp"
#include "phrame/ph/construct/hermite_spline.hpp"

namespace phrame::inline v0 {

/// A C¹ spline with h ≡ 0, exactly, near its data: its Euler–Rodrigues frame, which is rational, is
/// rotation-minimizing from one end to the other. Segment k is r′ = f·A i A* on [0, 1]; neighbours
/// have the derivative by the parameter and A in common, up to a real factor. Of generic data A is
/// cubic, a septic with f = h_k; between parallel tangents it is a plane quintic, on a line A is
/// constant and f quadratic. A closed one ends at its start, exactly, with the derivative there;
/// for that one of its segments has a quartic f, nearly constant. Throws DomainError where a
/// derivative is 0 at a joint, and where a segment is a point, Undecided where no septic was found,
/// with the segment.
/// Where points are met exactly, f of every segment is such a quartic; Undecided where none is near
/// enough to a constant.
Construction rmf_spline(const HermiteSpline& data, const Deviation& tolerance,
                        PointRule rule = PointRule::near);

}  // namespace phrame
