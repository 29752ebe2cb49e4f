#pragma once
#include <vector>

#include "phrame/algebra/near_poles.hpp"
#include "phrame/integrate/definite_integral.hpp"
#include "phrame/integrate/integrate.hpp"
#include "phrame/integrate/partial_fractions.hpp"

namespace phrame::inline v0 {

/// integrate(f, form), given algebraic_part(f) and, where they are known, near_poles() of f: they
/// often tell at once that its denominator is irreducible and its residues are distinct.
Antiderivative integrate(const RationalFunction& f, const AlgebraicPart& part, Form form,
                         const std::vector<NearPole>* poles);

/// ∫ f, and the simple fractions that the derivatives of its logarithms are, one for each of them;
/// none where they are not all over poles.
struct FactoredIntegral {
  Antiderivative F;
  std::vector<SimpleFraction> parts;
};
/// integrate(f), and what it has found of the poles.
FactoredIntegral factored_integral(const RationalFunction& f);

/// definite_integral(F, f, a, b, AtPoles::refuse) for the integral F of f. Poles from a to b are
/// not looked for where it is known that there are none.
DefiniteIntegral definite_integral(const FactoredIntegral& of, const RationalFunction& f,
                                   const Endpoint& a, const Endpoint& b, bool has_no_poles);

}  // namespace phrame
