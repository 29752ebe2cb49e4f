#pragma once
#include <functional>
#include <optional>

#include "phrame/ph/frame/frame_angle.hpp"

namespace phrame {

/// The angle in (−π, π] that differs from this one by whole turns, however many: decided exactly.
/// Where whole turns are taken from radians they stand in half_turns.
FrameAngle reduced(const FrameAngle& angle);

/// 2π·k.
Real whole_turn(const Integer& k);

/// angle = x − 2π·turns, in (−π, π].
struct ReducedAngle {
  Real angle;
  Integer turns;
};

/// `over_pi`, asked where x is near a multiple of π, is x/π if that is known to be rational: so ±π
/// are told apart, and 0 and π are exact. Throws Undecided where it is not known and x cannot be
/// told from an odd multiple of π.
ReducedAngle reduced(const Real& x, const std::function<std::optional<Rational>()>& over_pi);

/// x less the multiple of 2π next to its midpoint: a ball around a number of about [−π, π], for
/// what is measured and not decided.
RealBall reduced(const RealBall& x, long bits);

}  // namespace phrame
