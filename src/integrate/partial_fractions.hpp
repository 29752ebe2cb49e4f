#pragma once
#include "phrame/integrate/antiderivative.hpp"

namespace phrame::inline v0 {

/// n/d with d irreducible over ℚ (primitive) and deg n < deg d, n ≠ 0: one term of the partial
/// fraction decomposition over ℚ of a function with simple poles.
struct SimpleFraction {
  Polynomial numerator;    ///< n
  Polynomial denominator;  ///< d
};

/// f = Σ of simple fractions, one for each irreducible factor of its denominator, in the order of
/// factor(). A divisor of the denominator that is known saves time. Throws DomainError where f is
/// not proper or has a multiple pole.
std::vector<SimpleFraction> simple_fractions(const RationalFunction& f,
                                             const Polynomial& divisor = {1});

/// ∫ n/d = Σ c(z) log(t − z) over the roots z of d, c = n·(d′)⁻¹ mod d: full partial fractions
/// [Bronstein, Salvy 1993]. One modular inverse, no resultant.
LogSum full_partial_fraction(const SimpleFraction& f);

}  // namespace phrame
