#pragma once
#include "phrame/algebra/bivariate.hpp"

namespace phrame::inline v0 {

/// res_t(a, b), primitive, or 0: a polynomial in x with a root at the x of each common zero, of the
/// sum of the multiplicities of all that have this x. It is 0 where a and b have a common factor
/// that depends on t. Precondition: a, b ≠ 0. By values at small integers modulo primes, lifted by
/// the Chinese remainder theorem up to Hadamard's bound, so that it is proved. Cost: bits/61 times
/// degree + 1 Euclidean algorithms for polynomials in t modulo a prime.
Polynomial eliminant(const Bivariate& a, const Bivariate& b);

/// That bound times the degree + 1: the bits of all coefficients at most. Ten million take some two
/// seconds.
long eliminant_size(const Bivariate& a, const Bivariate& b);

/// The same polynomial in both unknowns, as one in x whose coefficients are polynomials in t.
Bivariate swapped(const Bivariate& v);

/// a/b, where that is a polynomial, b ≠ 0. Throws DomainError where it is none.
Bivariate exact_quotient(const Bivariate& a, const Bivariate& b);

}  // namespace phrame
