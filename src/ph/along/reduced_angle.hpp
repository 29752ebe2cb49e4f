#pragma once
#include <functional>
#include <optional>

#include "phrame/ph/along/frame_angle.hpp"

namespace phrame::inline v0 {

/// The angle in (−π, π] that differs from this one by any number of whole turns, decided exactly.
/// Whole turns that are taken from `radians` are in half_turns then.
FrameAngle reduced(const FrameAngle& angle);

/// 2π·k.
Real whole_turn(const Integer& k);

/// angle = x − 2π·turns, in (−π, π]; or next to π.
struct ReducedAngle {
  Real angle;
  Integer turns;
  /// Where the angle is π, or cannot be told from π: a bound of the difference. −π would do as
  /// well.
  std::optional<Rational> half_turn_within;
};

/// Reduces x by whole turns. `over_pi` is asked where x is near a multiple of π; it gives x/π where
/// that is known to be rational, so that π and −π are told apart, and 0 and π are exact. Where it
/// gives nothing, and most_bits do not tell x from an odd multiple of π, the angle next to π is
/// taken. Throws Undecided where the enclosures of x do not shrink.
ReducedAngle reduced(const Real& x, const std::function<std::optional<Rational>()>& over_pi,
                     long most_bits = 32768);
/// The same by what x knows of itself (algebraic_angle.hpp), for values that are dear: up to 256
/// bits.
ReducedAngle reduced(const Real& x);

/// x less the multiple of 2π next to its midpoint: a ball around a number of about [−π, π]. For
/// numbers that are measured, and from which nothing is decided.
RealBall reduced(const RealBall& x, long bits);

}  // namespace phrame
