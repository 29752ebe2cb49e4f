#pragma once
#include <vector>

#include "phrame/algebra/near_poles.hpp"
#include "phrame/integrate/integrate.hpp"

namespace phrame::inline v0 {

/// integrate(f, form), given algebraic_part(f) and, where they are known, near_poles() of f: they
/// often tell at once that its denominator is irreducible and its residues are distinct.
Antiderivative integrate(const RationalFunction& f, const AlgebraicPart& part, Form form,
                         const std::vector<NearPole>* poles);

}  // namespace phrame
