#pragma once
#include "phrame/algebra/polynomial.hpp"

namespace phrame::inline v0 {

// Polynomials over ℚ as power series of which only the first coefficients count, or read from the
// other end.

/// p modulo tⁿ, n ≥ 0.
Polynomial truncated(Polynomial p, long n);
/// t^{length−1}·p(1/t). Precondition: deg p < length.
Polynomial reversed(const Polynomial& p, long length);
/// exp p modulo tⁿ. Precondition: p(0) = 0.
Polynomial exp_series(const Polynomial& p, long n);

/// Σ sₖtᵏ, k < count, with the sums sₖ of the k-th powers of the roots of p ≠ 0.
Polynomial power_sums_of_roots(const Polynomial& p, long count);
/// The monic polynomial of degree s₀ with these sums of the powers of its roots, s₀, s₁, …, of
/// which there are more than s₀: Newton's identities.
Polynomial with_power_sums(const std::vector<Rational>& s);

}  // namespace phrame
