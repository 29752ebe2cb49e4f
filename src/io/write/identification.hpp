#pragma once
#include <string>

#include "phrame/answer/identification.hpp"

namespace phrame {

std::string to_text(const IdentificationAnswer& answer);   ///< for reading, Unicode
std::string to_json(const IdentificationAnswer& answer);   ///< identify/1
std::string to_latex(const IdentificationAnswer& answer);  ///< for amsmath and amssymb
std::string to_text(const PathIdentification& found);      ///< for reading, Unicode
std::string to_json(const PathIdentification& found);      ///< identify/1
std::string to_latex(const PathIdentification& found);     ///< for amsmath and amssymb

}  // namespace phrame
