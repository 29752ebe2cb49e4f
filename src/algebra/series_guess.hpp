#pragma once
#include "phrame/algebra/ball_polynomial.hpp"

namespace phrame {

// Guesses of the first coefficients of power series, at t⁰, …, t^{length−1}: from the middles of
// the balls, without radii, in floating point. Where s and q are short, a coefficient costs their
// degree; the balls of exact recurrences would get wider by some bits at each step. What a guess is
// worth shows when it is put into the equation that it is to satisfy.

/// Of 1/√s, s(0) > 0.
BallPolynomial guess_inverse_sqrt(const BallPolynomial& s, long length, long bits);
/// Of p/q, q(0) ≠ 0.
BallPolynomial guess_quotient(const BallPolynomial& p, const BallPolynomial& q, long length,
                              long bits);

/// Σ |cₖ|, or a bit more, without a radius: |p(t)| is no greater where |t| ≤ 1.
RealBall sum_of_sizes(const BallPolynomial& p);

}  // namespace phrame
