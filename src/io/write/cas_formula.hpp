#pragma once
#include "phrame/integrate/exact_value.hpp"
#include "phrame/integrate/real_form.hpp"
#include "phrame/io/write/radical_text.hpp"

namespace phrame::inline v0 {

/// The languages of computer-algebra systems; `plain` is what most of them read: + - * / ^,
/// parentheses, log, atan, pi.
enum class Language { plain, sympy, mathematica, maple, maxima, pari };

/// How that language writes radicals.
const RadicalNotation& radical_notation_of(Language language);

/// A variable that means nothing else in any of them: itself, if it is one lower-case Latin letter,
/// else "x".
std::string cas_variable(const std::string& variable);

// Formulas as a system reads them, exact, on one line. `variable` is a cas_variable().

/// A quotient of polynomials.
std::string cas_formula(const RationalFunction& f, Language language, const std::string& variable);
/// A sum over roots is a RootSum (SymPy, Mathematica), a sum over RootOf (Maple), an lsum over
/// rootsof (Maxima), or runs over polroots, in floating point (PARI). Its letter is "z", or "w"
/// where the variable is "z".
std::string cas_formula(const Antiderivative& F, Language language, const std::string& variable);
/// In PARI the sums that are left are real; in the other systems as those of an Antiderivative:
/// real up to a constant.
std::string cas_formula(const RealForm& F, Language language, const std::string& variable);
/// The same with these. Up to a constant between two real poles it is real: no |…|.
std::string cas_formula(const RealForm& F, const std::vector<LogSum>& sums_over_poles,
                        Language language, const std::string& variable);
/// A sum of multiples of π, logarithms and arctangents.
std::string cas_formula(const ExactValue& x, Language language);
/// "Float('1.5e-12', 2)", "1.5`1*^-12", "1.5b-12"; in Python of more than 4300 digits a quotient.
std::string cas_formula(const Decimal& x, Language language);

}  // namespace phrame
