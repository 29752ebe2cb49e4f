#pragma once
#include "phrame/algebra/integer.hpp"
#include "phrame/algebra/polynomial.hpp"

namespace phrame::inline v0 {

/// numerator/(scale·denominator), scale > 0, denominator primitive: a fraction of polynomials over
/// ℚ as it is reduced modulo primes.
struct IntegerFraction {
  IntegerPolynomial numerator;
  Integer scale;
  IntegerPolynomial denominator;
};

/// n/d, d ≠ 0.
IntegerFraction integer_fraction(const Polynomial& n, const Polynomial& d);

}  // namespace phrame
