#include "phrame/algebra/compact.hpp"

#include <algorithm>

namespace phrame::inline v0 {

Polynomial compact(Polynomial p) {
  fmpq_poly_struct* const raw = p.raw();
  const auto shrink = [](fmpz& x) {
    constexpr std::size_t least = 2;  // words, which FLINT takes for granted
    if (COEFF_IS_MPZ(x))
      mpz_realloc2(COEFF_TO_PTR(x), GMP_NUMB_BITS * std::max(least, mpz_size(COEFF_TO_PTR(x))));
  };
  for (slong k = 0; k < raw->length; ++k) shrink(raw->coeffs[k]);
  shrink(*raw->den);
  return p;
}

}  // namespace phrame
