#include "phrame/algebra/power_series.hpp"

namespace phrame::inline v0 {

Polynomial truncated(Polynomial p, long n) {
  fmpq_poly_truncate(p.raw(), n);
  return p;
}

Polynomial reversed(const Polynomial& p, long length) {
  Polynomial result;
  fmpq_poly_reverse(result.raw(), p.raw(), length);
  return result;
}

Polynomial exp_series(const Polynomial& p, long n) {
  Polynomial result;
  fmpq_poly_exp_series(result.raw(), p.raw(), n);
  return result;
}

Polynomial power_sums_of_roots(const Polynomial& p, long count) {
  Polynomial s;
  fmpq_poly_power_sums(s.raw(), p.raw(), count);
  return s;
}

Polynomial with_power_sums(const std::vector<Rational>& s) {
  Polynomial p;
  fmpq_poly_power_sums_to_poly(p.raw(), Polynomial(s).raw());
  return p;
}

}  // namespace phrame
