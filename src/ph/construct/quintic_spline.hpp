#pragma once
#include "phrame/ph/construct/construction.hpp"
#include "phrame/ph/construct/hermite_spline.hpp"

namespace phrame::inline v0 {

/// A C¹ spline of PH quintics, exactly, near its data. Segment k is r′ = h_k·A i A* on [0, 1], h_k
/// the step of the parameter, so that neighbours have the derivative by the parameter in common:
/// the coefficient of A at a joint is the same for both. A closed one ends at its start, exactly,
/// with the derivative there; for that its last segment is halved. Throws DomainError where a
/// derivative is 0 at a joint, so that the tangent would break there, and where a segment is a
/// point, Undecided where a spline could not be closed and where a point could not be met exactly.
Construction quintic_spline(const HermiteSpline& data, const QuinticChoice& choice,
                            const Deviation& tolerance, PointRule rule = PointRule::near);
/// The same with the angles of each segment.
Construction quintic_spline(const HermiteSpline& data, const std::vector<FreeAngles>& angles,
                            const Deviation& tolerance, PointRule rule = PointRule::near);

}  // namespace phrame
