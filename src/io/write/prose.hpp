#pragma once
#include "phrame/io/write/text.hpp"

namespace phrame::inline v0 {

// Words for a text and for LaTeX at once. Formulas stand between $, as in LaTeX, but their signs
// are those of Unicode, with a \ before names of functions: "helix with $\cos ψ = 1/2$".

/// The words in Unicode, "helix with cos ψ = 1/2", or in LaTeX, "helix with $\cos \psi = 1/2$".
/// A formula in LaTeX already stays what it is.
std::string prose(std::string_view words, Notation notation);

/// A formula among such words: in LaTeX between $.
std::string formula(const std::string& text, Notation notation);

}  // namespace phrame
