#pragma once
#include "phrame/ph/construct/construction.hpp"
#include "phrame/ph/construct/hermite_spline.hpp"

namespace phrame::inline v0 {

/// C² splines of PH quintics, exactly, near their points: the second derivatives by the parameter
/// are equal at the joints, too. Segment k is r′ = h_k·A i A* on [0, 1] with h_k the step of the
/// parameter, A quadratic and C¹ in the parameter. Of the derivatives an open spline has those at
/// its ends; those between are where the search begins. Points of the plane z = 0, with such
/// derivatives, have a spline in it. A closed one ends at its start, exactly, and is C² there; for
/// that the segment that turns most is divided in six; so is every segment where points are to be
/// met exactly. Throws DomainError where a derivative at an
/// end is 0 and where a closed spline has less than three segments, Undecided where no spline was
/// found, as with parameters that go far from the lengths of the chords.
Construction c2_spline(const HermiteSpline& data, const Deviation& tolerance,
                       PointRule rule = PointRule::near);

/// At the joints of a path whose segments have constant multipliers h, and at its end where it is
/// closed: are r′/h and r″/h² the same on both sides, so that with these steps of the parameter it
/// is C²? Equality is that of fractions. Not so of other paths.
bool is_c2(const PhPath& path, bool is_closed);

}  // namespace phrame
