#include "phrame/ph/frame/frame_start.hpp"

namespace phrame {

// n = (Re g·e₂ − Im g·e₃)/|g|, so that an angle to n is that to e₂ and arg g.
FrameAngle start_angle(const FrameStart& start, const Path& path, Reference reference) {
  if (const auto* angle = std::get_if<Angle>(&start)) return *angle;
  const Curve& first = path.segments().front();
  const FrameAngle to_erf =
      angle_of(std::get<StartNormal>(start).vector, euler_rodrigues_frame(first, 0));
  if (reference == Reference::euler_rodrigues) return to_erf;
  const GaussianRational z = direction_of(to_erf).value();
  return angle_of(z * bend_after_zero(first.preimage()));
}

}  // namespace phrame
