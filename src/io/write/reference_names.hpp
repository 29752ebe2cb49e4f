#pragma once
#include <string>
#include <utility>
#include <vector>

#include "phrame/answer/angle.hpp"

namespace phrame {

/// What an angle is measured from, as it is called on the command line and in JSON.
inline const std::vector<std::pair<std::string, Reference>> reference_names{
    {"erf", Reference::euler_rodrigues}, {"frenet", Reference::frenet}};

inline const std::string& name_of(Reference reference) {
  return reference_names[reference == Reference::euler_rodrigues ? 0 : 1].first;
}

}  // namespace phrame
