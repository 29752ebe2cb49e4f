#pragma once
#include "phrame/ph/construct/construction.hpp"
#include "phrame/ph/construct/helical_quintics.hpp"

namespace phrame::inline v0 {

/// A C¹ spline of quintics whose tangents have a constant angle to an axis, each segment to one of
/// its own, exactly, near its data. Taken is in each segment the `solution`-th of
/// helical_quintics(). A segment is f·A i A*, f(0) the step of the parameter; at a joint √f·A is
/// the same for both but for a rational factor. Open. Throws DomainError as quintic_spline, and
/// where a segment has fewer solutions; Undecided where the end cannot be met because all depends
/// on a turn by too little. Where points are met exactly, f is of degree 4 and nearly what it was,
/// and the same at the joints; Undecided where there is no such f, as of straight segments.
Construction helical_spline(const HermiteSpline& data, long solution, const Deviation& tolerance,
                            PointRule rule = PointRule::near);

/// Does A stay in a real plane of ℍ on each segment, as an identity?
bool is_helical(const PhPath& path);

}  // namespace phrame
