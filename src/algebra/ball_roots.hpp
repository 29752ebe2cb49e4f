#pragma once
#include <vector>

#include "phrame/algebra/ball_polynomial.hpp"

namespace phrame::inline v0 {

/// What is known of the roots of a polynomial with balls for coefficients.
struct BallRoots {
  /// One root in each, the real ones exactly real, where `are_isolated`; else guesses.
  std::vector<ComplexBall> all;
  /// Is it proved that each ball has one root, and no real root another one?
  bool are_isolated;
};

/// All complex roots of p, degree_bound() ≥ 1 of them, with a leading coefficient that is not 0 and
/// finite others: from those of the polynomial in the middle by Durand's and Kerner's iteration,
/// then proved, where the balls are narrow enough and no two roots are too close.
BallRoots ball_roots(const BallPolynomial& p, long bits);

}  // namespace phrame
