#pragma once
#include "phrame/ph/construct/construction.hpp"
#include "phrame/ph/construct/hermite_spline.hpp"

namespace phrame::inline v0 {

/// At most so many PH cubics have the same ends and tangents.
inline constexpr long cubic_solutions = 2;

/// A G¹ spline of PH cubics, exactly, near its points and the directions of its derivatives: A is
/// linear, and at a joint that of one segment is a multiple of that of the other. There are none,
/// one or two to a segment; taken is the `solution`-th by bending energy. `derivatives` of the
/// tolerance and the deviation are angles between tangents. Throws DomainError, with the segment,
/// where there is no such cubic, and where a derivative is 0. Where points are met exactly, each
/// segment has a quadratic multiplier near 1, so it is of degree 5; Undecided where there is none.
Construction cubic_spline(const HermiteSpline& data, long solution, const Deviation& tolerance,
                          PointRule rule = PointRule::near);

}  // namespace phrame
