#pragma once
#include "phrame/integrate/path_end.hpp"
#include "phrame/io/read/expression.hpp"

namespace phrame::inline v0 {

/// Reads an end:
///   an expression without a variable: "3/7", "1e-3", "(1+2)/3";
///   "inf", "infinity", "oo" or "∞", with or without a sign;
///   one in pi: "pi", "2*pi/3", "1 - π^2"; one with a square root: "sqrt(2)", "(1+√5)/2";
///   "root(x^2-2, 1, 2)", the only root of that polynomial between the two ends, which may be
///   infinite.
/// What is rational is a Rational. Throws InputError like parse_expression, also where there are no
/// or several such roots, for square roots of several numbers, and for both pi and a square root.
PathEnd parse_endpoint(std::string_view text, const ExpressionLimits& limits = {});

}  // namespace phrame
