#pragma once
#include "phrame/algebra/polynomial.hpp"
#include "phrame/ph/curve/real_vector.hpp"
#include "phrame/ph/frame/frame_verdict.hpp"

namespace phrame::inline v0 {

/// What a frame that somebody gives at some t is compared with. The vectors are ≠ 0, of any length.
struct ExactFrame {
  Vector<Real> tangent;                ///< along e₁
  Vector<Real> second;                 ///< along e₂
  std::optional<Vector<Real>> normal;  ///< along n or −n, where that is defined
  RealBall theta;                      ///< the angle of the rotation-minimizing frame to e₂
  int side;                            ///< T is e₁ times it; 0 where it may be either
};

/// What the given frame is off, in balls with a radius of about 2^−bits. That a vector is 0 or
/// along another one, and the sign of a determinant, are decided exactly where the vectors are
/// exact; else what 2048 bits do not tell from 0 is taken for 0.
FrameDeviation deviation_from(const ExactFrame& exact, const GivenFrame& frame, long bits);

/// The sign of f next to t: 0 where it changes there.
int sign_beside(const Polynomial& f, const Rational& t);

}  // namespace phrame
