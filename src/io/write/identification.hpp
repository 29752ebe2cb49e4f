#pragma once
#include <string>

#include "phrame/answer/identification.hpp"

namespace phrame {

std::string to_text(const IdentificationAnswer& answer);
std::string to_json(const IdentificationAnswer& answer);  ///< identify/1
std::string to_text(const PathIdentification& found);
std::string to_json(const PathIdentification& found);  ///< identify/1

}  // namespace phrame
