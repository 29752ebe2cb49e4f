#pragma once
#include "phrame/ph/construct/construction.hpp"
#include "phrame/ph/construct/hermite_spline.hpp"

namespace phrame::inline v0 {

/// A G¹ spline of quintics with rational rotation-minimizing frames, of class I, exactly, near its
/// points and the directions of its derivatives. Of each segment's quintics it is one of little
/// energy. The numbers of all segments are about as long. `derivatives` of the
/// tolerance and the deviation are angles between tangents. Open. Throws DomainError where a
/// derivative is 0 or two points that follow each other are equal, Undecided where no such quintic
/// is found. Where points are met exactly, f is of degree 2 and nearly constant; Undecided where
/// there is no such f, as of straight segments.
Construction rrmf_spline(const HermiteSpline& data, const Deviation& tolerance,
                         PointRule rule = PointRule::near);

/// Are the Bernstein coefficients of A on each segment such that S(A₀, A₂) = A₁ i A₁*, so that it
/// has a rational rotation-minimizing frame?
bool is_rrmf_of_class_one(const PhPath& path);

}  // namespace phrame
