#pragma once
#include <variant>

#include "phrame/ph/curve/path.hpp"
#include "phrame/ph/frame/frame.hpp"

namespace phrame {

/// Where f₂ is to be at the start of a path: along this vector, once that is projected to the
/// normal plane.
struct StartNormal {
  Vector<Rational> vector;  ///< of any length, neither 0 nor along the tangent

  /// Along this vector.
  explicit StartNormal(Vector<Rational> along) : vector(std::move(along)) {}
  friend bool operator==(const StartNormal&, const StartNormal&) = default;
};

/// Where a rotation-minimizing frame starts, at t = 0 of the first segment: at an angle to the
/// frame that angles are measured from, or with f₂ along a vector.
using FrameStart = std::variant<Angle, StartNormal>;

/// θ(0), exactly; that of a vector is in (−π, π]. At a cusp the frames are those that are continued
/// through it; where the curve starts with an inflection, the Frenet frame is that of small t > 0.
/// Throws DomainError for a vector that is 0 or along the tangent, and where it is measured from
/// the Frenet frame of a straight line.
FrameAngle start_angle(const FrameStart& start, const Path& path,
                       Reference reference = Reference::euler_rodrigues);

}  // namespace phrame
