#include "phrame/ph/frame/frame_start.hpp"

#include "phrame/algebra/error.hpp"
#include "phrame/ph/curve/vector.hpp"

namespace phrame::inline v0 {

// n = (Re g·e₂ − Im g·e₃)/|g|, so that an angle to n is that to e₂ and arg g.
FrameAngle start_angle(const FrameStart& start, const Curve& first, Reference reference,
                       const Vector<Rational>& up, const Rational& t) {
  if (const auto* angle = std::get_if<Angle>(&start)) return *angle;
  const Frame<Rational> erf = euler_rodrigues_frame(first, t);
  const auto* least = std::get_if<LeastRotation>(&start);
  const FrameAngle to_erf = angle_of(
      least != nullptr ? least_rotation_normal(erf.e1) : std::get<StartNormal>(start).vector, erf);
  const FrameAngle turn = least != nullptr ? least->turn : Angle();
  if (reference == Reference::euler_rodrigues) return to_erf + turn;
  if (reference == Reference::up && up == Vector<Rational>{})
    throw DomainError("the up vector is 0");
  const GaussianRational z = direction_of(to_erf).value();
  const GaussianRational g = reference == Reference::up
                                 ? GaussianRational{dot(up, erf.e3), dot(up, erf.e2)}
                                 : bend_after_zero(first.preimage());
  return angle_of(z * g) + turn;
}

FrameAngle start_angle(const FrameStart& start, const PhPath& path, Reference reference) {
  if (reference == Reference::up)
    throw DomainError("the angle to the frame of a vector v is that of PathAngle(path, v)");
  return start_angle(start, path.segments().front(), reference);
}

// For e = e₁ ≠ −i the rotation takes j to j − e₂/(1 + e₁)·(i + e); a multiple of e does not count.
Vector<Rational> least_rotation_normal(const Vector<Rational>& e1) {
  if (e1[0] == -1) return {0, 1, 0};
  return {-e1[1], 1 + e1[0], 0};
}

}  // namespace phrame
