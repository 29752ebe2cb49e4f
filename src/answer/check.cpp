#include "phrame/answer/check.hpp"

#include "phrame/ph/frame/frame_check.hpp"

namespace phrame::inline v0 {

CheckAnswer answer(const NamedPath& named, const CheckQuery& query) {
  const PathAngle angle = angle_to(query.options.up, named.path);
  CheckAnswer answer{named, query.frames, query.options,
                     check_frames(angle, query.frames, query.options)};
  if (angle.reference() == Reference::up) answer.up = angle.up();
  return answer;
}

}  // namespace phrame
