#pragma once
#include <cstdlib>
#include <vector>

#include "phrame/algebra/polynomial.hpp"

namespace phrame::inline v0 {

// Arithmetic without copies and without fractions in lowest terms on the way, where many numbers
// are computed.

/// @{ sum ± a·b.
inline void add_product(Integer& sum, const Integer& a, const Integer& b) {
  fmpz_addmul(sum.raw(), a.raw(), b.raw());
}
inline void subtract_product(Integer& sum, const Integer& a, const Integer& b) {
  fmpz_submul(sum.raw(), a.raw(), b.raw());
}
inline void add_product(Integer& sum, const Integer& a, unsigned long b) {
  fmpz_addmul_ui(sum.raw(), a.raw(), b);
}
/// @}

/// |a| > |b|.
inline bool is_longer(const Integer& a, const Integer& b) {
  return fmpz_cmpabs(a.raw(), b.raw()) > 0;
}

/// x/y to the nearest integer.
inline Integer nearest_quotient(const Integer& x, const Integer& y) {
  Integer twice = x;
  twice <<= 1;
  twice += y;
  fmpz_fdiv_q(twice.raw(), twice.raw(), (y << 1).raw());
  return twice;
}

/// d becomes a multiple of the denominator, too, the least one.
inline void include_denominator(Integer& d, const Rational& x) {
  fmpz_lcm(d.raw(), d.raw(), fmpq_denref(x.raw()));
}

/// d·x, for a multiple d of its denominator.
inline Integer whole_multiple(const Rational& x, const Integer& d) {
  Integer result;
  fmpz_divexact(result.raw(), d.raw(), fmpq_denref(x.raw()));
  fmpz_mul(result.raw(), result.raw(), fmpq_numref(x.raw()));
  return result;
}

/// n·2^−k.
inline Rational over_power_of_two(const Integer& n, long k) {
  Rational result(n);
  const auto places = static_cast<ulong>(std::abs(k));
  if (k > 0)
    fmpq_div_2exp(result.raw(), result.raw(), places);
  else
    fmpq_mul_2exp(result.raw(), result.raw(), places);
  return result;
}

/// Σ C(m, k)·Δᵏb₀·tᵏ, m = size of b − 1 ≥ 0: the polynomial with these Bernstein
/// coefficients, the shortest way for low degrees.
inline Polynomial from_differences(const std::vector<Rational>& b) {
  Polynomial result(b);
  const auto m = static_cast<slong>(b.size()) - 1;
  const slong known = fmpq_poly_length(result.raw());
  fmpz* c = fmpq_poly_numref(result.raw());  // with room for all of b
  _fmpz_vec_zero(c + known, m + 1 - known);
  _fmpq_poly_set_length(result.raw(), m + 1);
  for (slong k = 1; k <= m; ++k)
    for (slong j = m; j >= k; --j) fmpz_sub(c + j, c + j, c + j - 1);
  ulong binomial = 1;
  for (slong k = 1; k <= m; ++k) {
    binomial = binomial * static_cast<ulong>(m - k + 1) / static_cast<ulong>(k);
    fmpz_mul_ui(c + k, c + k, binomial);
  }
  fmpq_poly_canonicalise(result.raw());
  return result;
}

}  // namespace phrame
