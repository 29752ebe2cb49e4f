#pragma once
#include <optional>

#include "phrame/algebra/rational_function.hpp"
#include "phrame/integrate/endpoint.hpp"

namespace phrame::inline v0 {

/// x = ∫ₐᵇ f, where b is so near to a, measured by the distance of the poles of f, that few terms
/// of the Taylor series at a are enough; no value elsewhere. However small x is, it is known
/// relatively: the ball has a radius ≤ 2^−bits·|x|, or where the terms cancel each other ≤ 2^−bits
/// times the sum of their sizes and ≤ 2^−bits. There is no pole between the ends, then. The ends
/// are finite. Cost: for a = 0 next to nothing where there is no value.
std::optional<RealBall> short_integral(const RationalFunction& f, const Endpoint& a,
                                       const Endpoint& b, long bits);

}  // namespace phrame
