#pragma once
#include "phrame/algebra/ball.hpp"
#include "phrame/algebra/near_arithmetic.hpp"
#include "phrame/algebra/near_complex.hpp"

namespace phrame::inline v0 {

// Elementary functions of numbers that are known to about 2^−100, in rounding to nearest, some
// hundred nanoseconds each. Their errors are proved: tables of a few values by balls, Taylor
// polynomials between them, and what these leave out. An infinite error where that is of no use.

/// The numbers of the ball.
NearNumber near_number(const RealBall& x);
/// All that x may be, for a finite error.
RealBall ball_of(const NearNumber& x);

struct NearCosSin {
  NearNumber cos;
  NearNumber sin;
};
/// Both for an angle in radians of up to 2^20.
NearCosSin cos_sin(const NearNumber& angle);

/// The principal logarithm. Infinite errors where z may be on the negative real axis, where the
/// logarithm jumps, and for |z| beyond 2^±400.
NearComplex log(const NearComplex& z);

/// 1/√x for x > 0.
NearNumber inverse_root(const NearNumber& x);

}  // namespace phrame
