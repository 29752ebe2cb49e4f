#include "phrame/answer/classification.hpp"

namespace phrame::inline v0 {

ClassificationAnswer answer(const NamedPath& named, const ClassificationQuery&) {
  return {named, classify(named.path)};
}

}  // namespace phrame
