#pragma once
#include "phrame/algebra/polynomial.hpp"

namespace phrame::inline v0 {

// Bounds of determinants of Sylvester matrices by Hadamard's inequality, after the substitution
// t → 2ˢt that makes them least: for all coefficients of one size s = 0 does, for roots of size r
// it is about log₂ r.

/// √(Σ|fₖ|²) ≤ 2^bits. So Mahler's measure of f ≠ 0, the product of |lead(f)| and of the absolute
/// values of the roots that are > 1, is ≤ 2^bits [Landau 1905], and no coefficient is greater.
long norm_bits(const flint::FmpzPoly& f);

/// For a, q ≠ 0: the degree D ≥ deg a with deg n < D + deg q for which
/// R = lead(q)^{D − deg a}·res(q, a), the resultant of a as a polynomial of degree D, makes
/// R·(n·a⁻¹ mod q) a polynomial with integer coefficients.
long formal_degree(const flint::FmpzPoly& n, const flint::FmpzPoly& a, const flint::FmpzPoly& q);

/// R and these coefficients are below 2^bits in absolute value.
long cofactor_bits(const flint::FmpzPoly& n, const flint::FmpzPoly& a, const flint::FmpzPoly& q);

/// For deg n < deg d ≥ 1: the coefficients of res_t(n − x·d′, d) are below 2^bits.
long residue_bits(const flint::FmpzPoly& n, const flint::FmpzPoly& d);

}  // namespace phrame
