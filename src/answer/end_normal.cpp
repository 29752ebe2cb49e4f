#include "phrame/answer/end_normal.hpp"

#include "phrame/algebra/error.hpp"
#include "phrame/ph/frame/frame.hpp"

namespace phrame {

void require_open(const std::optional<Vector<Rational>>& end_normal, bool is_closed) {
  if (end_normal && is_closed)
    throw DomainError("end normal: the path is closed, it ends with the normal it starts with");
}

FrameAngle end_angle(const Vector<Rational>& end_normal, const PhPath& path) {
  return angle_of(end_normal, euler_rodrigues_frame(path.segments().back(), 1));
}

}  // namespace phrame
