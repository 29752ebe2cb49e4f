#pragma once
#include "phrame/integrate/exact_value.hpp"
#include "phrame/integrate/real_form.hpp"
#include "phrame/io/write/formula.hpp"

namespace phrame::inline v0 {

/// The letters of a formula.
struct Letters {
  std::string variable = "t";  ///< of the function
  std::string pole = "z";      ///< what a sum over poles runs over
  std::string residue = "x";   ///< what a sum over residues runs over
};

/// Letters that are not `variable`, which is written as the notation can: "\theta",
/// "\mathit{t\_1}".
Letters letters_for(const std::string& variable, Notation notation);

/// "4t(t − 1)" in factors over ℚ, a passage where that is long.
std::string readable_factors(const Polynomial& p, std::string_view variable = "t");

/// "−8t(t − 1)/(t⁴ + 1)" in factors over ℚ, "\frac{…}{…}".
std::string formatted_quotient(const RationalFunction& f, Notation notation,
                               std::string_view variable = "t");

/// @{ The terms of a formula, those with a minus sign beginning with it. In Unicode long
/// polynomials are abbreviated, and a sum over roots goes on in a second line, which says what its
/// c(z) is.
std::vector<std::string> formatted_terms(const Antiderivative& F, Notation notation,
                                         const Letters& letters = {});
std::vector<std::string> formatted_terms(const RealForm& F, Notation notation,
                                         const Letters& letters = {});
std::vector<std::string> formatted_terms(const TextbookForm& F, Notation notation,
                                         const Letters& letters = {});
std::vector<std::string> formatted_terms(const ExactValue& x, Notation notation);
/// @}

/// How the logarithms of F are written: "partial-fractions" where all sums are over poles,
/// "rothstein-trager" where none is and their polynomials are irreducible, "lazard-rioboo-trager"
/// where one of these is not, else "mixed"; "rational" where there is no logarithm.
std::string form_name(const Antiderivative& F);

/// The terms with their signs, `before` each but the first; "0" where there are none.
std::string formatted_sum(const std::vector<std::string>& terms, std::string_view before,
                          Notation notation);

}  // namespace phrame
