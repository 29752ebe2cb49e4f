#pragma once
#include <functional>
#include <optional>

#include "phrame/ph/along/frame_angle.hpp"

namespace phrame {

/// The angle in (−π, π] that differs from this one by whole turns, however many: decided exactly.
/// Where whole turns are taken from radians they stand in half_turns.
FrameAngle reduced(const FrameAngle& angle);

/// 2π·k.
Real whole_turn(const Integer& k);

/// angle = x − 2π·turns, in (−π, π]; or next to π.
struct ReducedAngle {
  Real angle;
  Integer turns;
  /// Where the angle is π, or not told from it: it is as near to π as this, so that −π would do as
  /// well.
  std::optional<Rational> half_turn_within;
};

/// `over_pi`, asked where x is near a multiple of π, is x/π if that is known to be rational: so ±π
/// are told apart, and 0 and π are exact. Where it is not known and so many bits do not tell x from
/// an odd multiple of π, the angle next to π is taken. Throws Undecided where the enclosures of x
/// do not shrink.
ReducedAngle reduced(const Real& x, const std::function<std::optional<Rational>()>& over_pi,
                     long most_bits = 32768);
/// The same with what x knows of itself, algebraic_angle.hpp, and where values are dear: up to 256
/// bits.
ReducedAngle reduced(const Real& x);

/// x less the multiple of 2π next to its midpoint: a ball around a number of about [−π, π], for
/// what is measured and not decided.
RealBall reduced(const RealBall& x, long bits);

}  // namespace phrame
