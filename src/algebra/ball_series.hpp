#pragma once
#include "phrame/algebra/ball_polynomial.hpp"

namespace phrame {

// Polynomials with real balls for coefficients as power series in t, of which the coefficients of
// t⁰, …, t^{length−1} are computed.

BallPolynomial multiply_series(const BallPolynomial& p, const BallPolynomial& q, long length,
                               long bits);
/// p/q; the coefficients are not finite where q(0) is not kept from 0.
BallPolynomial divide_series(const BallPolynomial& p, const BallPolynomial& q, long length,
                             long bits);
/// 1/√p; not finite unless p(0) > 0.
BallPolynomial inverse_sqrt_series(const BallPolynomial& p, long length, long bits);

struct CosSinSeries {
  BallPolynomial cos;
  BallPolynomial sin;
};
CosSinSeries cos_sin_series(const BallPolynomial& p, long length, long bits);

}  // namespace phrame
