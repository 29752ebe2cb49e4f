#pragma once
#include <vector>

#include "phrame/algebra/ball.hpp"

namespace phrame::inline v0 {

/// Enclosures of all complex roots of the squarefree f, one root in each, in no order; those of
/// real roots are exactly real. Each is at least sixteen times as far from the next as it is wide,
/// and has a relative accuracy of `bits` bits (0: isolated only). `start` has as many exact points
/// as f has roots. Empty where the roots are not apart at a precision at which they must be.
///
/// Arithmetic is that of balls of 128 bits or more, doubled for the roots that are not settled, as
/// in MPSolve. What proves the result is not the iteration but Smith's discs. Cost: O(n²)
/// operations where the start is good; a cluster of m roots that are δ apart needs m·log₂(1/δ)
/// bits. [Bini, Fiorentino 2000; Smith 1970].
std::vector<ComplexBall> enclose_roots(const flint::FmpzPoly& f, std::vector<ComplexBall> start,
                                       long bits);

}  // namespace phrame
