#pragma once
#include <string_view>

#include "phrame/export.hpp"
#include "phrame/ph/along/feedrate.hpp"

namespace phrame::inline v0 {

/// Reads a feedrate as it is typed, a function of s (arc length), t (parameter) or kappa, also κ
/// (signed curvature of a plane curve): "50", "10 + 2*s", "5 + t^2", "5/(1 + 2*kappa)"; with the
/// functions of parse_formula(), "sqrt(4 + 2*s)"; the least or the greatest of several, each of one
/// of them, "min(50, 10 + s, max(5, 9/kappa))"; and pieces, "s < 3 ? 10 : s < 5 ? 20 : 10", told
/// apart by s or by t. Throws InputError as parse_expression and parse_formula, and where it
/// depends on anything else.
PHRAME_API Feedrate parse_feedrate(std::string_view text);

}  // namespace phrame
