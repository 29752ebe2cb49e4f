#pragma once
#include "phrame/algebra/ball.hpp"

namespace phrame::inline v0 {

// Logarithms, of complex numbers the principal ones, with an imaginary part in (−π, π] and all of
// [−π, π] where the ball meets the negative real axis; log1p(x) = log(1 + x), accurate also next to
// x = 0. Not finite where a ball contains what has no logarithm.

RealBall log(RealBall x, long bits);
RealBall log1p(RealBall x, long bits);
ComplexBall log(ComplexBall z, long bits);
ComplexBall log1p(ComplexBall z, long bits);

}  // namespace phrame
