#pragma once
#include <functional>
#include <optional>

#include "phrame/algebra/real.hpp"

namespace phrame {

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

}  // namespace phrame
