#pragma once
#include "phrame/algebra/radical.hpp"

namespace phrame::inline v0 {

/// All roots of a squarefree polynomial whose irreducible factors have degree ≤ 4, by Cardano's
/// and Ferrari's formulas [Farouki 2003, Appendix A], in the order of isolate_roots(p, …): real
/// ones ascending, then those above the real axis, then their conjugates.
/// Square and cube roots of numbers that are real and not 0 have positive radicands, except where
/// a cubic has three real roots: then ∛(R + √Δ) + ∛(R − √Δ), Δ < 0, is the sum of two conjugates,
/// and a quartic's resolvent may be such a cubic.
/// Checked before it is returned: enclosures of the radicals meet the certified enclosures of the
/// roots one to one. Throws DomainError where p is constant or not squarefree, and for an
/// irreducible factor of a degree > 4, which the message names.
std::vector<Radical> roots_by_radicals(const Polynomial& p);

}  // namespace phrame
