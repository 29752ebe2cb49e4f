#include "phrame/answer/identification.hpp"

namespace phrame {

IdentificationAnswer answer(const NamedHodograph& query) {
  return {query.name, identify(query.hodograph, query.start)};
}

}  // namespace phrame
