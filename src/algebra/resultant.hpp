#pragma once
#include "phrame/algebra/polynomial.hpp"

namespace phrame::inline v0 {

/// The residue polynomial R(x) = res_t(n(t) − x·d′(t), d(t)), primitive: its roots are the residues
/// n(z)/d′(z) of n/d, a residue met at k poles being a root of multiplicity k. deg R = deg d.
/// Computed modulo primes as a multiple of the characteristic polynomial of n/d′ in 𝔽ₚ[t]/(d)
/// and lifted by the Chinese remainder theorem up to Hadamard's bound of the Sylvester determinant,
/// so that the lift is proved. Precondition, else DomainError: d squarefree, deg n < deg d ≥ 1.
Polynomial residue_polynomial(const Polynomial& n, const Polynomial& d);

/// How many roots the residue polynomial of n/d has modulo a prime, the larger number of two
/// primes: there are at least so many different residues. Same preconditions.
long distinct_residues_modulo_a_prime(const Polynomial& n, const Polynomial& d);

/// Are these as many as there are poles? Then the residues are pairwise distinct; false proves
/// nothing. Same preconditions.
bool residues_are_distinct_modulo_a_prime(const Polynomial& n, const Polynomial& d);

}  // namespace phrame
