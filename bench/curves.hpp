#pragma once
#include <string>

#include "phrame/phrame.hpp"

namespace phrame::inline v0::bench {

/// A curve file: u, v, p, q of degree m with random integer coefficients in [−9, 9], the same in
/// every run. The curve has degree 2m + 1.
std::string random_curve_text(long m);

Curve random_curve(long m);

/// A Bézier curve of that degree, with control points of one digit; no PH curve.
Path bezier_path(long degree);

}  // namespace phrame::bench
