#pragma once
#include "phrame/ph/construct/construction.hpp"
#include "phrame/ph/construct/hermite_spline.hpp"

namespace phrame::inline v0 {

/// C² splines of degree 9, exactly, near their points, derivatives and accelerations [Šír,
/// Jüttler]. Segment k is r′ = h_k·A i A* on [0, 1], h_k the step of the parameter and A a quartic,
/// C¹ in the parameter. Always to be had: A is turned from point to point by the minimal rotation,
/// h = 0 at the points, and what is left is one quaternion a segment, from B i B* = c. A closed
/// spline ends at its start, exactly, and is C² there; for that its last segment is halved; so is
/// every segment where points are to be met exactly. Throws DomainError where there are no
/// accelerations and where a derivative is 0, Undecided where a spline could not be closed.
Construction c2_hermite_spline(const HermiteSpline& data, const Deviation& tolerance,
                               PointRule rule = PointRule::near);

}  // namespace phrame
