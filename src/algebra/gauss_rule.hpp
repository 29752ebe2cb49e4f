#pragma once
#include <vector>

#include "phrame/algebra/ball.hpp"

namespace phrame::inline v0 {

/// Gauss's rule on [−1, 1]: Σ weightₖ·f(pointₖ) is ∫ f for every polynomial f of a degree < 2n.
struct GaussRule {
  std::vector<RealBall> points;   ///< the zeros of Legendre's polynomial Pₙ, ascending
  std::vector<RealBall> weights;  ///< > 0
};

/// That of n ≥ 1 points, in balls of so many bits.
GaussRule gauss_rule(long n, long bits);

}  // namespace phrame
