#pragma once
#include "phrame/io/write/cas_formula.hpp"
#include "phrame/io/write/text.hpp"

namespace phrame::inline v0 {

// An irrational algebraic number x times a name, "√2/4·π", "(1 + √5)/10·π": in radicals where x has
// a degree ≤ 4 and they are real, else as the root of its polynomial in an interval.

/// "π·(the root of 8x³ − 6x + 1 in (0, 1/2))", in LaTeX with the decimal.
std::string formatted_multiple(const RealAlgebraic& x, std::string_view name, Notation notation);

/// For a system: "1/4*sqrt(2)*pi"; roots as phrame reads them, root(p, a, b), or CRootOf (SymPy),
/// Root (Mathematica), RootOf (Maple), polrootsreal (PARI), find_root (Maxima, in floating point).
std::string cas_multiple(const RealAlgebraic& x, std::string_view name, Language language);

}  // namespace phrame
