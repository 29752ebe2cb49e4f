#pragma once
#include <string>

#include "phrame/integrate/pole_table.hpp"

namespace phrame {

/// A row for each real pole and for each pair of conjugate ones, 12 correct digits a component; one
/// that may be 0 is shown as a bound, "(|·| < 1.3e-4932)". Poles that are only counted are a
/// passage.
std::string to_text(const PoleTable& table);

}  // namespace phrame
