#pragma once
#include "phrame/ph/frame/frame.hpp"

namespace phrame::inline v0 {

inline constexpr long rotation_bits = 96;  ///< which are enough to round nearly all frames
/// Of θ, for all but one in some hundreds: so many come from poles in doubles.
inline constexpr long few_rotation_bits = 64;

/// B = A/|A|·(cos φ + i·sin φ) at t, φ = θ/2, within some 2^−bits: the unit quaternion of the
/// Euler–Rodrigues frame of A, turned about e₁ by θ; −B for a sign < 0. Precondition: A has no zero
/// at t.
Quaternion<RealBall> rotation_ball(const QuaternionPolynomial& a, const Rational& t,
                                   const RealBall& theta, int sign = 1, long bits = rotation_bits);

/// Every component correctly rounded; no value where the balls leave a rounding open, as that of
/// a component that is 0 but not seen to be.
std::optional<Frame<double>> rounded_frame(const Quaternion<RealBall>& b);

}  // namespace phrame
