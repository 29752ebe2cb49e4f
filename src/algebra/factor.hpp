#pragma once
#include "phrame/algebra/polynomial.hpp"
#include "phrame/export.hpp"

namespace phrame::inline v0 {

/// A power in a factorization.
struct Factor {
  Polynomial base;  ///< coprime integer coefficients, positive leading one, degree ≥ 1
  long exponent;    ///< ≥ 1
  friend bool operator==(const Factor&, const Factor&) = default;
};

/// p = unit · ∏ baseᵏ with bases that are coprime in pairs. They are sorted by degree, then
/// exponent, then absolute values of the coefficients from the highest down: equal polynomials have
/// equal factorizations, and t comes before t − 1.
struct Factorization {
  Rational unit;                ///< content(p), with its sign
  std::vector<Factor> factors;  ///< none for a constant
};

/// The bases are squarefree and the exponents distinct (Yun). Throws DomainError for 0.
PHRAME_API Factorization squarefree_factorization(const Polynomial& p);

/// The bases are irreducible over ℚ. Throws DomainError for 0.
PHRAME_API Factorization factor(const Polynomial& p);

}  // namespace phrame
