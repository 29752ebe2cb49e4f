#pragma once
#include "phrame/algebra/bivariate.hpp"

namespace phrame::inline v0 {

/// A power in a factorization.
struct BivariateFactor {
  Bivariate base;  ///< primitive_part() of itself, irreducible over ℚ, no constant
  long exponent;   ///< ≥ 1
};
/// v = c·∏ baseᵏ with c ∈ ℚ, by the degrees of the bases in t and then in x. Throws DomainError for
/// 0, and Undecided where FLINT gives up.
std::vector<BivariateFactor> factor(const Bivariate& v);

/// The greatest common divisor, primitive_part() of itself; gcd(0, 0) = 0. Throws Undecided where
/// FLINT gives up.
Bivariate gcd(const Bivariate& a, const Bivariate& b);

}  // namespace phrame
