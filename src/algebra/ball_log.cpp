#include "phrame/algebra/ball_log.hpp"

namespace phrame::inline v0 {

RealBall log(RealBall x, long bits) {
  arb_log(x.raw(), x.raw(), bits);
  return x;
}

RealBall log1p(RealBall x, long bits) {
  arb_log1p(x.raw(), x.raw(), bits);
  return x;
}

ComplexBall log(ComplexBall z, long bits) {
  acb_log(z.raw(), z.raw(), bits);
  return z;
}

ComplexBall log1p(ComplexBall z, long bits) {
  acb_log1p(z.raw(), z.raw(), bits);
  return z;
}

}  // namespace phrame
