#pragma once
#include <string>
#include <vector>

#include "phrame/ph/proof/classify.hpp"
#include "phrame/ph/proof/stated_decisions.hpp"
#include "phrame/ph/proof/statement.hpp"

namespace phrame::inline v0 {

/// As a certificate has them.
StatedDecisions stated(const Classification& c);

/// No objection where it holds.
inline std::string unless(bool holds, const char* objection) { return holds ? "" : objection; }

/// Decides each by classifying the curve; a witness is checked by its identity, and may be another
/// one than `classify` finds.
std::vector<Statement> check_decisions(const StatedDecisions& d, const Curve& curve);

}  // namespace phrame
