#pragma once
#include "phrame/algebra/complex_of.hpp"
#include "phrame/algebra/polynomial.hpp"
#include "phrame/export.hpp"

namespace phrame::inline v0 {

using GaussianPolynomial = ComplexOf<Polynomial>;  ///< a polynomial over ℚ(i)

PHRAME_API bool is_zero(const GaussianPolynomial& a);  ///< are both parts 0?
/// The greater degree of the two parts; −1 for 0.
PHRAME_API long degree(const GaussianPolynomial& a);
PHRAME_API GaussianPolynomial differentiate(const GaussianPolynomial& a);  ///< a′
/// a over its leading coefficient. Throws DomainError for 0.
PHRAME_API GaussianPolynomial monic(const GaussianPolynomial& a);
/// a / b, where b divides a. Throws DomainError where it does not.
PHRAME_API GaussianPolynomial exact_quotient(const GaussianPolynomial& a,
                                             const GaussianPolynomial& b);
/// The monic greatest common divisor, proved by dividing a and b; gcd(0, 0) = 0.
/// Cost: Euclid's algorithm modulo as many primes as the result, not a or b, is long.
PHRAME_API GaussianPolynomial gcd(const GaussianPolynomial& a, const GaussianPolynomial& b);

/// Writes "(t^2 - 1) + (2*t)*i".
PHRAME_API std::ostream& operator<<(std::ostream& out, const GaussianPolynomial& p);

}  // namespace phrame
