#pragma once
#include "phrame/ph/curve/expression_curve.hpp"
#include "phrame/ph/curve/formula_program.hpp"

namespace phrame::inline v0 {

/// A point or a direction at a parameter of an expression curve, as steps of a program that several
/// may share: where two steps are the same, so are the numbers.
using ExactVector = Vector<std::size_t>;
/// @{ dⁿr/dsⁿ for n ≤ 3, r, and dr/ds or its opposite, along H, at a rational t, put into the
/// program.
ExactVector exact_derivative(const ExpressionCurve& curve, std::size_t order, const Rational& t,
                             FormulaProgram& program);
ExactVector exact_point(const ExpressionCurve& curve, const Rational& t, FormulaProgram& program);
ExactVector exact_direction(const ExpressionCurve& curve, const Rational& t,
                            FormulaProgram& program);
/// @}

/// Are the two vectors equal? Decided where they have the same form or are rational, else by balls
/// of up to 1024 bits; no value where they are equal to all these bits.
std::optional<bool> are_equal(const FormulaProgram& program, const ExactVector& a,
                              const ExactVector& b);
/// Are they positive multiples of each other? Likewise. Neither is 0.
std::optional<bool> have_same_direction(const FormulaProgram& program, const ExactVector& a,
                                        const ExactVector& b);

}  // namespace phrame
