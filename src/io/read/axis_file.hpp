#pragma once
#include <string_view>

#include "phrame/io/read/curve_file.hpp"
#include "phrame/ph/offset/envelope.hpp"

namespace phrame::inline v0 {

/// Reads an mph/1 file: one curve with radii, or `segments`, a list of such, which need not follow
/// each other. Each is given by `control_points` [x, y, r]; by the polynomials `x`, `y` and `r`, in
/// a `basis`; or by a `preimage` u, v, p, q, with `start` [x, y, r], which may be left out where
/// the segment before ends, and optionally `multiplier`. Throws InputError, also where a curve has
/// no square x′² + y′² − r′².
PHRAME_API NamedAxis read_axis(std::string_view text, const CurveLimits& limits = {});

}  // namespace phrame
