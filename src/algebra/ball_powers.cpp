#include "phrame/algebra/ball_powers.hpp"

namespace phrame {

BallPowers::BallPowers(const RealBall& x, long length, long bits) : bits_(bits) {
  arb_poly_fit_length(powers_.raw(), length);
  _arb_vec_set_powers(powers_.raw()->coeffs, x.raw(), length, bits);
  _arb_poly_set_length(powers_.raw(), length);
}

RealBall BallPowers::value_of(const BallPolynomial& p) const {
  RealBall value;
  arb_dot(value.raw(), nullptr, 0, p.raw()->coeffs, 1, powers_.raw()->coeffs, 1, p.raw()->length,
          bits_);
  return value;
}

}  // namespace phrame
