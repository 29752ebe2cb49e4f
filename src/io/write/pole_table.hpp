#pragma once
#include <string>

#include "phrame/integrate/antiderivative.hpp"

namespace phrame {

/// The poles z of F′ and their residues c(z), a row for each real pole and for each pair of
/// conjugate ones, 12 correct digits a component. "0" is proved; a component that 16384 bits do not
/// tell from 0 is shown as a bound, "(|·| < 1.3e-4932)".
/// Empty where a sum of F is not over its poles, and where there are none. More than 24 are
/// counted, unless `all` are to be listed.
std::string pole_table(const Antiderivative& F, bool all = false);

}  // namespace phrame
