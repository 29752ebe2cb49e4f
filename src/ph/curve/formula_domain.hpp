#pragma once
#include "phrame/ph/curve/expression_curve.hpp"

namespace phrame::inline v0 {

/// A part [lower, upper] of the parameter t ∈ [0, 1] of 2^−40 or less at which, or next to which,
/// something is wrong.
struct NarrowPart {
  Rational lower;
  Rational upper;
};

/// Why is the curve not seen to be analytic and regular there? Throws DomainError, with the formula
/// and the place, where it is proved to be undefined: where a divisor is exactly 0 at a simple
/// place, or has two signs; where the argument of a logarithm or root is negative or exactly 0;
/// and for a cusp, where r′ is exactly 0 at a simple place, by its form. A place is simple if s is
/// the simplest fraction of the part, or the simplest multiple of π. Else Undecided.
[[noreturn]] void refuse_part(const ExpressionCurve& curve, const NarrowPart& narrow);

/// The part and what is next to it, on both sides 64 times as long as it is.
NarrowPart widened_part(const NarrowPart& part);

/// The simple place of the part where these three are 0, by their form.
std::optional<Formula> simple_zero(const ExpressionCurve& curve, const NarrowPart& part,
                                   const Vector<Formula>& of);

/// Throws DomainError where the curvature is proved to be 0 there, at an inflection, with the place
/// and what is asked; else Undecided.
[[noreturn]] void refuse_inflection(const ExpressionCurve& curve, const NarrowPart& narrow,
                                    const std::string& what);

}  // namespace phrame
