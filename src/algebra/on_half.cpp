#include "phrame/algebra/on_half.hpp"

namespace phrame {

// 2ⁿ·Σ cₖ·((t + s)/2)ᵏ = Σ 2ⁿ⁻ᵏ·cₖ·(t + s)ᵏ.
Polynomial on_half(const Polynomial& p, long shift) {
  if (p.is_constant()) return p;
  flint::FmpzPoly numerator;
  fmpq_poly_get_numerator(numerator.get(), p.raw());
  const slong n = p.degree();
  for (slong k = 0; k < n; ++k) {
    fmpz* c = fmpz_poly_get_coeff_ptr(numerator.get(), k);
    fmpz_mul_2exp(c, c, static_cast<ulong>(n - k));
  }
  flint::Fmpz by;
  fmpz_set_si(by.get(), shift);
  fmpz_poly_taylor_shift(numerator.get(), numerator.get(), by.get());
  flint::Fmpz denominator;
  fmpz_mul_2exp(denominator.get(), fmpq_poly_denref(p.raw()), static_cast<ulong>(n));
  Polynomial result;
  fmpq_poly_set_fmpz_poly(result.raw(), numerator.get());
  fmpq_poly_scalar_div_fmpz(result.raw(), result.raw(), denominator.get());
  return result;
}

}  // namespace phrame
