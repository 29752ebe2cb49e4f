#include "phrame/answer/classification.hpp"

namespace phrame {

ClassificationAnswer answer(const NamedCurve& named, const ClassificationQuery&) {
  return {named, classify(named.curve)};
}

}  // namespace phrame
