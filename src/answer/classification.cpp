#include "phrame/answer/classification.hpp"

namespace phrame {

ClassificationAnswer answer(const NamedPhPath& named, const ClassificationQuery&) {
  return {named, classify(named.path)};
}

}  // namespace phrame
