#include "phrame/ph/frame/frame_start.hpp"

#include "phrame/algebra/error.hpp"
#include "phrame/ph/curve/vector.hpp"

namespace phrame::inline v0 {
namespace {

/// From e₂ to the normal n of least rotation, as of B j B* where B = A·e^{iφ}/|A| has no part along
/// i: (u + iv)·e^{iφ} is real, and n·e₂ + i·n·e₃ along e^{2iφ} = (u − iv)²/|u − iv|².
FrameAngle to_least_rotation(const Curve& curve, const Rational& t) {
  const RationalQuaternion a = evaluate(curve.preimage(), t);
  if (a.u != 0 || a.v != 0) {
    const GaussianRational w{a.u, -a.v};
    return angle_of(GaussianRational{2 / norm(a), 0} * w * w);
  }
  const Frame<Rational> erf = euler_rodrigues_frame(curve, t);
  return angle_of(least_rotation_normal(erf.e1), erf);
}

}  // namespace

// n = (Re g·e₂ − Im g·e₃)/|g|, so that an angle to n is that to e₂ and arg g.
FrameAngle start_angle(const FrameStart& start, const Curve& first, Reference reference,
                       const Vector<Rational>& up, const Rational& t) {
  if (const auto* angle = std::get_if<Angle>(&start)) return *angle;
  const auto* least = std::get_if<LeastRotation>(&start);
  const FrameAngle to_erf = least != nullptr ? to_least_rotation(first, t)
                                             : angle_of(std::get<StartNormal>(start).vector,
                                                        euler_rodrigues_frame(first, t));
  const FrameAngle turn = least != nullptr ? least->turn : Angle();
  if (reference == Reference::euler_rodrigues) return to_erf + turn;
  if (reference == Reference::up && up == Vector<Rational>{})
    throw DomainError("the up vector is 0");
  const GaussianRational z = direction_of(to_erf).value();
  if (reference != Reference::up) return angle_of(z * bend_after_zero(first.preimage())) + turn;
  const Frame<Rational> erf = euler_rodrigues_frame(first, t);
  return angle_of(z * GaussianRational{dot(up, erf.e3), dot(up, erf.e2)}) + turn;
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
