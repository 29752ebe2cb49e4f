#pragma once
#include "phrame/ph/curve/expression_curve.hpp"

namespace phrame::inline v0 {

/// What a function f does about a point c, as far as its form says.
enum class FormulaSymmetry {
  constant,  ///< f does not depend on the variable
  even,      ///< f(c + h) = f(c − h)
  skew,      ///< f(c + h) + f(c − h) = 2f(c): an odd function of h and a constant
  unknown,   ///< nothing is seen
};

/// About this c, a constant at which f is defined, by the steps of f: products, quotients and
/// powers of even and odd functions, and sines and cosines of skew ones whose value at c is seen to
/// be a multiple of π/2.
FormulaSymmetry symmetry_about(const Formula& f, const Formula& c);

/// Is r(1 − t) = M r(t) + b, M being half a turn about an axis of coordinates which v is along or
/// normal to, by the form of r? Then the frame e₂ = v × e₁/|v × e₁| at 1 − t is that at t, turned
/// by M and half a turn about the tangent or none, so that its rate of rotation is the same at
/// both, as the speed is.
bool is_turned_over_by_half_turn(const ExpressionCurve& curve, const Vector<Rational>& v);

}  // namespace phrame
