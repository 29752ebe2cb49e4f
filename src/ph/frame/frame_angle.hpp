#pragma once
#include "phrame/algebra/angle.hpp"
#include "phrame/algebra/gaussian_integer.hpp"
#include "phrame/ph/frame/frame.hpp"

namespace phrame {

/// An angle that a frame is to have, exactly: π·half_turns + radians + arg direction.
struct FrameAngle {
  Rational half_turns;               ///< the multiple of π
  Rational radians;                  ///< what is added to it
  GaussianRational direction{1, 0};  ///< re > 0, or a positive multiple of i
  friend bool operator==(const FrameAngle&, const FrameAngle&) = default;
};

/// The principal argument of z ≠ 0, in (−π, π].
FrameAngle angle_of(const GaussianRational& z);

/// The angle to (e₂, e₃) of v projected to their plane. Throws DomainError where that is 0.
FrameAngle angle_of(const Vector<Rational>& v, const Frame<Rational>& frame);

/// The angle over π where that is rational; no value where it is not: decided exactly.
std::optional<Rational> over_pi(const FrameAngle& angle);

/// @{ b − a, and the sum, whole turns included.
FrameAngle difference(const FrameAngle& b, const FrameAngle& a);
FrameAngle operator+(const FrameAngle& a, const FrameAngle& b);
/// @}

/// 1 at t = 0 and z at t = 1, straight on and not through 0, so that its argument turns by arg z;
/// for the z of a FrameAngle.
GaussianPolynomial path_to(const GaussianRational& z);

/// Exact where the angle is rational.
Real to_real(const FrameAngle& angle);

}  // namespace phrame
