#pragma once
#include <string_view>

#include "phrame/export.hpp"
#include "phrame/ph/along/feedrate.hpp"

namespace phrame::inline v0 {

/// Reads a feedrate as it is typed, a rational function of s (arc length), t (parameter) or kappa,
/// also κ (signed curvature of a plane curve): "50", "10 + 2*s", "5 + t^2", "5/(1 + 2*kappa)".
/// Throws InputError as parse_expression, and where it depends on anything else.
PHRAME_API Feedrate parse_feedrate(std::string_view text);

}  // namespace phrame
