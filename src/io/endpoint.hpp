#pragma once
#include "phrame/integrate/endpoint.hpp"
#include "phrame/io/expression.hpp"

namespace phrame {

/// Reads an end: an expression without a variable ("3/7", "1e-3", "(1+2)/3"), "inf", "infinity" or
/// "∞" with or without a sign, or "root(x^2-2, 1, 2)", the only root of that polynomial between
/// the two ends, which may be infinite. A rational root is a Rational.
/// Throws InputError like parse_expression, also where there are no or several such roots.
Endpoint parse_endpoint(std::string_view text, const ExpressionLimits& limits = {});

/// "3/7", "−∞", "the root of x² − 2 in (1, 2)".
std::string to_text(const Endpoint& end);

}  // namespace phrame
