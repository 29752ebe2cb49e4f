#include "phrame/answer/classification.hpp"

namespace phrame {

ClassificationAnswer answer(const NamedPath& named, const ClassificationQuery&) {
  return {named, classify(named.path)};
}

}  // namespace phrame
