#pragma once
#include "phrame/ph/curve/path.hpp"

namespace phrame {

/// Vectors ≠ 0 of whose sums and multiples all H of the segment are, at least one. Of a rational
/// curve these are the only ones. Of a curve by formulas they are found by the form of r′, as sums
/// of multiples of the same functions: c₁f₁(s) + c₂f₂(s) + …, and there may be more than needed.
std::vector<Vector<Rational>> direction_span(const RationalCurve& curve);
std::vector<Vector<Rational>> direction_span(const ExpressionCurve& curve);
std::vector<Vector<Rational>> direction_span(const Segment& segment);  ///< likewise
/// Of those of all segments, one after the other, the ones that are in no line or plane of others
/// before: three at most.
std::vector<Vector<Rational>> direction_span(const Path& path);

/// Are all these, none of them 0, along one line?
bool are_on_a_line(const std::vector<Vector<Rational>>& directions);
/// A vector normal to all of them, of integers without a common factor; no value where they are
/// along a line, or in no plane.
std::optional<Vector<Rational>> common_normal(const std::vector<Vector<Rational>>& directions);

}  // namespace phrame
