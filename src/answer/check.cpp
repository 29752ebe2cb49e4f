#include "phrame/answer/check.hpp"

#include "phrame/ph/frame/smooth_check.hpp"

namespace phrame {

CheckAnswer answer(const NamedPhPath& named, const CheckQuery& query) {
  return {named, query.frames, query.options,
          check_frames(named.path, query.frames, query.options)};
}

CheckAnswer answer(const NamedPath& named, const CheckQuery& query) {
  const SmoothAngle angle =
      query.options.up ? SmoothAngle(named.path, *query.options.up) : SmoothAngle(named.path);
  return {named, query.frames, query.options, check_frames(angle, query.frames, query.options),
          angle.up()};
}

}  // namespace phrame
