#include "phrame/algebra/power_series.hpp"

#include "phrame/algebra/result_of.hpp"

namespace phrame::inline v0 {

Polynomial truncated(Polynomial p, long n) {
  fmpq_poly_truncate(p.raw(), n);
  return p;
}

Polynomial reversed(const Polynomial& p, long length) {
  return result_of<Polynomial>(fmpq_poly_reverse, p.raw(), length);
}

Polynomial exp_series(const Polynomial& p, long n) {
  return result_of<Polynomial>(fmpq_poly_exp_series, p.raw(), n);
}

Polynomial power_sums_of_roots(const Polynomial& p, long count) {
  return result_of<Polynomial>(fmpq_poly_power_sums, p.raw(), count);
}

Polynomial with_power_sums(const std::vector<Rational>& s) {
  return result_of<Polynomial>(fmpq_poly_power_sums_to_poly, Polynomial(s).raw());
}

}  // namespace phrame
