#pragma once
#include "phrame/ph/curve/path.hpp"

namespace phrame::inline v0 {

/// Vectors ≠ 0, at least one, such that H is a sum of multiples of them everywhere on the segment.
/// Of a rational curve there are no more than needed. Of a curve by formulas they are found by the
/// form of r′, as a sum of multiples of the same functions, c₁f₁(s) + c₂f₂(s) + …, and there may be
/// more.
std::vector<Vector<Rational>> direction_span(const RationalCurve& curve);
std::vector<Vector<Rational>> direction_span(const ExpressionCurve& curve);
std::vector<Vector<Rational>> direction_span(const Segment& segment);  ///< likewise
/// The vectors of all segments, one after the other, but for those that are on the line or in the
/// plane of vectors before them: three at most.
std::vector<Vector<Rational>> direction_span(const Path& path);

/// Are all these vectors, none of which is 0, along one line?
bool are_on_a_line(const std::vector<Vector<Rational>>& directions);
/// A vector normal to all of these, of integers without a common factor. No value where they are
/// along a line, or in no plane.
std::optional<Vector<Rational>> common_normal(const std::vector<Vector<Rational>>& directions);

}  // namespace phrame
