#pragma once
#include <string>

#include "phrame/answer/construction.hpp"

namespace phrame {

std::string to_text(const ConstructionAnswer& answer);  ///< for reading, Unicode
std::string to_json(const ConstructionAnswer& answer);  ///< construct/1
/// The same rows as an align*, and the segments as a tabular.
std::string to_latex(const ConstructionAnswer& answer);

/// The names of the rules that select one of the quintics, with their rules.
const std::vector<std::pair<std::string, QuinticSelection>>& quintic_selections();

}  // namespace phrame
