#pragma once
#include <vector>

#include "phrame/algebra/bivariate.hpp"

namespace phrame::inline v0 {

/// Is v(c(z), z) = 0 for every root z of d and every v of the list, where c = n/d′ is the residue
/// of n/d at z? Decided modulo primes: one denies it, and so many that a bound is reached prove it.
/// Requires d squarefree, deg n < deg d ≥ 1. Cost: the factorization of d, and about
/// (b + M·(B + b_d))/61 images, for v of degree M in x with coefficients of b bits, n and d′ of B
/// and d of b_d; an image costs 2√(M·deg_t v) products modulo d.
bool vanish_at_residues(const std::vector<Bivariate>& list, const Polynomial& n,
                        const Polynomial& d);

}  // namespace phrame
