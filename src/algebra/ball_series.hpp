#pragma once
#include "phrame/algebra/ball_polynomial.hpp"

namespace phrame::inline v0 {

// Polynomials with real balls for coefficients as power series in t, of which the coefficients of
// t⁰, …, t^{length−1} are computed.

/// p without what is beyond.
BallPolynomial truncated(BallPolynomial p, long length);
/// p·q.
BallPolynomial multiply_series(const BallPolynomial& p, const BallPolynomial& q, long length,
                               long bits);
/// Σ pⱼ·q_{n−j}, the coefficient of tⁿ in p·q, rounded once.
RealBall coefficient_of_product(const BallPolynomial& p, const BallPolynomial& q, long n,
                                long bits);
/// Makes c the coefficient of tᵏ.
void set_coefficient(BallPolynomial& p, long k, const RealBall& c);
/// p/q; the coefficients are not finite where q(0) is not kept from 0.
BallPolynomial divide_series(const BallPolynomial& p, const BallPolynomial& q, long length,
                             long bits);
/// 1/√p; not finite unless p(0) > 0.
BallPolynomial inverse_sqrt_series(const BallPolynomial& p, long length, long bits);

/// The cosine and the sine of one series.
struct CosSinSeries {
  BallPolynomial cos;  ///< cos p
  BallPolynomial sin;  ///< sin p
};
/// Both of p.
CosSinSeries cos_sin_series(const BallPolynomial& p, long length, long bits);
/// exp p.
BallPolynomial exp_series(const BallPolynomial& p, long length, long bits);
/// log p; not finite unless p(0) > 0.
BallPolynomial log_series(const BallPolynomial& p, long length, long bits);
/// arctan p.
BallPolynomial atan_series(const BallPolynomial& p, long length, long bits);
/// √p; not finite unless p(0) > 0.
BallPolynomial sqrt_series(const BallPolynomial& p, long length, long bits);
/// pᵏ, k ≥ 0.
BallPolynomial pow_series(const BallPolynomial& p, unsigned long k, long length, long bits);

}  // namespace phrame
