#pragma once
#include <memory>

#include "phrame/algebra/algebraic_angle.hpp"
#include "phrame/ph/curve/place.hpp"

namespace phrame::inline v0 {

/// θ of the rotation-minimizing frame to the frame of v, along the lines and plane curves that a
/// path begins with, as an algebraic angle. Copies share what was found; any thread may ask.
class PlaneTurns {
 public:
  /// Precondition: v is nowhere along the tangent.
  PlaneTurns(const Path& path, const Vector<Rational>& v);

  /// θ there up to whole turns; no value behind the first segment that is in no plane, and where
  /// the tangent is not seen to be along a rational vector. What rest() has none of is of too many
  /// different roots.
  std::optional<AngleForm> at(const Place& at) const;

 private:
  struct State;
  std::shared_ptr<State> state_;
};

}  // namespace phrame
