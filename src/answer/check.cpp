#include "phrame/answer/check.hpp"

#include "phrame/ph/frame/frame_check.hpp"

namespace phrame {

CheckAnswer answer(const NamedPhPath& named, const CheckQuery& query) {
  return {named, query.frames, query.options,
          check_frames(PathAngle(named.path), query.frames, query.options)};
}

CheckAnswer answer(const NamedPath& named, const CheckQuery& query) {
  const PathAngle angle = query.options.up ? PathAngle(named.path, *query.options.up)
                                           : PathAngle(named.path, Reference::up);
  return {named, query.frames, query.options, check_frames(angle, query.frames, query.options),
          angle.up()};
}

}  // namespace phrame
