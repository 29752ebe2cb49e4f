#pragma once
#include <string>
#include <vector>

#include "phrame/integrate/pole_table.hpp"

namespace phrame::inline v0 {

/// A real pole, or a pair of conjugate ones, "0.1 ± 0.2i", with its residue; 12 correct digits a
/// component.
struct PoleTexts {
  std::string pole;     ///< z
  std::string residue;  ///< c(z), the lower sign being that of the conjugate
};
/// Of each row; one that may be 0 is shown as a bound, "(|·| < 1.3e-4932)".
std::vector<PoleTexts> texts_of(const PoleTable& table);

/// These, a line each. Poles that are only counted are a passage.
std::string to_text(const PoleTable& table);

}  // namespace phrame
