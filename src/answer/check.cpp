#include "phrame/answer/check.hpp"

#include "phrame/ph/smooth/smooth_check.hpp"

namespace phrame {

CheckAnswer answer(const NamedPath& named, const CheckQuery& query) {
  return {named, query.frames, query.options,
          check_frames(named.path, query.frames, query.options)};
}

CheckAnswer answer(const NamedSmoothPath& named, const CheckQuery& query) {
  const SmoothAngle angle =
      query.options.up ? SmoothAngle(named.path, *query.options.up) : SmoothAngle(named.path);
  return {named, query.frames, query.options, check_frames(angle, query.frames, query.options),
          angle.up()};
}

}  // namespace phrame
