#include "phrame/answer/check.hpp"

namespace phrame {

CheckAnswer answer(const NamedPath& named, const CheckQuery& query) {
  return {named, query.frames, query.options,
          check_frames(named.path, query.frames, query.options)};
}

}  // namespace phrame
