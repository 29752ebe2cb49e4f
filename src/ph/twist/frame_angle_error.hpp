#pragma once
#include "phrame/algebra/real.hpp"
#include "phrame/ph/curve/quaternion.hpp"

namespace phrame::inline v0 {

/// How far the angle of a rational frame, the Euler–Rodrigues frame turned by 2·arg(b + ia), is
/// from that of the rotation-minimizing frame which has its direction at t = 0:
///   e(t) = ∫₀ᵗ (2h/σ − 2(ab′ − a′b)/(a² + b²)).
struct FrameAngleError {
  Real greatest;  ///< max |e| on [0, 1]: exact where e = 0, else in balls
  Real at_end;    ///< e(1)
};

/// Common factors of a and b are no matter. Precondition: not both are 0, and the preimage has no
/// real zero on [0, 1].
FrameAngleError frame_angle_error(const QuaternionPolynomial& preimage, const Polynomial& a,
                                  const Polynomial& b);

}  // namespace phrame
