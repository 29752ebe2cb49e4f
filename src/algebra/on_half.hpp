#pragma once
#include "phrame/algebra/polynomial.hpp"

namespace phrame {

/// p((t + shift)/2), at the cost of additions: for a polynomial in t ∈ [−1, 1] on the left half of
/// that, shift = −1, and on the right one, shift = 1.
Polynomial on_half(const Polynomial& p, long shift);

}  // namespace phrame
