#pragma once
#include "phrame/algebra/ball_polynomial.hpp"

namespace phrame {

/// 1, x, x², …: for the values of several polynomials at one x.
class BallPowers {
 public:
  /// x⁰, …, x^{length−1}, computed, as the values are, with so many bits.
  BallPowers(const RealBall& x, long length, long bits);

  /// p(x). Precondition: p.degree_bound() < length.
  RealBall value_of(const BallPolynomial& p) const;

 private:
  BallPolynomial powers_;
  long bits_;
};

}  // namespace phrame
