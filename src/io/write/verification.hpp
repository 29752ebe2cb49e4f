#pragma once
#include <string>
#include <vector>

#include "phrame/ph/proof/statement.hpp"

namespace phrame {

/// A line for each statement of a certificate, and how many are not proved.
std::string to_text(const std::vector<Statement>& statements);

}  // namespace phrame
