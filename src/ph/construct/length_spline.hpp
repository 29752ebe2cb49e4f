#pragma once
#include "phrame/ph/construct/construction.hpp"
#include "phrame/ph/construct/hermite_spline.hpp"

namespace phrame::inline v0 {

/// A spline of PH quintics from point to point, each with the tangents at its ends and of the
/// length that is given for it, exactly a spline and near its data. A segment has the same speed at
/// both ends, and there is one quintic for every Δ and φ [Farouki 2019]: Δ is that of the least
/// energy, φ = 0. With the steps of the parameter that are these speeds the spline is C¹ and has a
/// derivative of about 1 at all joints. Throws DomainError for a length that is not greater than
/// the distance of the points, and where a derivative is 0.
Construction length_spline(const HermiteSpline& data, const std::vector<Rational>& lengths,
                           const Deviation& tolerance);

/// The lengths of the segments: those given, one for each, or one of the whole, in proportion to
/// the chords, to 40 bits. Throws DomainError for another number of them.
std::vector<Rational> segment_lengths(const HermiteSpline& data,
                                      const std::vector<Rational>& given);

}  // namespace phrame
