#pragma once
#include "phrame/ph/construct/quintic_spline.hpp"

namespace phrame::inline v0 {

/// How many plane quintics a segment has.
inline constexpr long plane_solutions = 4;

/// C¹ splines as quintic_spline, of data in the plane z = 0 and in that plane. To each segment
/// there are four plane quintics, Δ and φ being 0 or half a turn [Farouki, Neff 1995]; taken is the
/// one that turns least, or of the second, third and fourth that one. `solution` is from 1 to
/// plane_solutions. Throws DomainError where the data are not in that plane, and as quintic_spline.
Construction plane_quintics(const HermiteSpline& data, long solution, const Deviation& tolerance,
                            PointRule rule = PointRule::near);

}  // namespace phrame
