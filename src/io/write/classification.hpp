#pragma once
#include <string>

#include "phrame/answer/classification.hpp"

namespace phrame {

std::string to_text(const ClassificationAnswer& answer);  ///< for reading, Unicode
std::string to_json(const ClassificationAnswer& answer);  ///< classify/1

}  // namespace phrame
