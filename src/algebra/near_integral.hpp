#pragma once
#include <optional>

#include "phrame/algebra/unit_quotient.hpp"

namespace phrame::inline v0 {

/// ∫₀¹ c·N/(D√S) of a UnitQuotient, which no longer is of x ∈ [−1, 1], within about 2^−88 of that
/// of its absolute value: by Gauss's rule in pairs of doubles, on parts of [0, 1] around which
/// ellipses are proved to be free of zeros of D and S. What the rule leaves out is bounded by the
/// size of the quotient on these, and what is rounded by that on the points. No value where doubles
/// do not prove that S > 0 and D ≠ 0 on [0, 1], or not so many bits, and where there would be many
/// parts, or degrees are high.
std::optional<RealBall> near_integral(const UnitQuotient& f);

}  // namespace phrame
