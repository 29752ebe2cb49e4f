// By Cramer's rule on Sylvester's matrix, the coefficients of u in u·a + v·q = res(q, a)·n are
// determinants with deg q − 1 rows of a, deg a rows of q and one of n, so that
//   |u_k| ≤ ‖n‖·‖a‖^{deg q − 1}·‖q‖^{deg a}.
// Where deg n ≥ deg a + deg q, a is taken for a polynomial of the degree deg n − deg q + 1, whose
// leading coefficients are 0.
// For n(ρt), a(ρt), q(ρt) the same bounds ρ^{deg a·deg q}·u(ρt), so that
//   |u_k| ≤ ρ^{−deg a·deg q − k}·‖n(ρt)‖·‖a(ρt)‖^{deg q − 1}·‖q(ρt)‖^{deg a}.
// On |x| = 1 the determinant res_t(n − x·d′, d) has N = deg d rows of norm ≤ ‖n‖ + ‖d′‖ and N − 1
// rows of d, and no coefficient exceeds the maximum over the unit circle (Cauchy).
#include "phrame/algebra/hadamard.hpp"

#include <algorithm>
#include <cmath>

namespace phrame::inline v0 {
namespace {

using flint::Mag;

/// An upper bound of ‖f(2ˢt)‖₂; in doubles, where they reach far enough.
Mag norm(const flint::FmpzPoly& f, long s) {
  constexpr long most_bits = 400;
  const slong length = fmpz_poly_length(f.get());
  if (std::abs(fmpz_poly_max_bits(f.get())) + std::abs(s) * length <= most_bits) {
    double squares = 0;
    double power = 1;
    for (slong k = 0; k < length; ++k, power *= std::ldexp(1.0, static_cast<int>(s))) {
      const double term = power * fmpz_get_d(fmpz_poly_get_coeff_ptr(f.get(), k));
      squares += term * term;
    }
    Mag bound;
    mag_set_d(bound.get(), std::sqrt(squares) * (1 + 0x1p-30));  // more than what was rounded
    return bound;
  }
  Mag sum;
  Mag term;
  for (slong k = 0; k < length; ++k) {
    mag_set_fmpz(term.get(), fmpz_poly_get_coeff_ptr(f.get(), k));
    mag_mul_2exp_si(term.get(), term.get(), s * k);
    mag_addmul(sum.get(), term.get(), term.get());
  }
  mag_sqrt(sum.get(), sum.get());
  return sum;
}

void multiply_by_power(Mag& a, const Mag& base, long exponent) {
  Mag power;
  mag_pow_ui(power.get(), base.get(), static_cast<ulong>(exponent));
  mag_mul(a.get(), a.get(), power.get());
}

/// a < 2^bits.
long bits(const Mag& a) { return mag_is_zero(a.get()) != 0 ? 0 : fmpz_get_si(MAG_EXPREF(a.get())); }

/// The least bound(s), found from the s of the geometric mean of the roots of q; they are convex
/// in s. Below 0 the determinant is 0 and they have no least.
template <class Bound>
long least(const flint::FmpzPoly& q, Bound bound) {
  const slong n = fmpz_poly_degree(q.get());
  const auto size = [&](slong k) {
    return static_cast<long>(fmpz_bits(fmpz_poly_get_coeff_ptr(q.get(), k)));
  };
  long s = size(0) == 0 ? 0 : (size(0) - size(n)) / n;
  long best = bound(s);
  for (const long step : {-1, 1})
    for (long next = bound(s + step); next < best && best > 0; next = bound(s + step)) {
      best = next;
      s += step;
    }
  return std::max(best, 0L);
}

}  // namespace

long norm_bits(const flint::FmpzPoly& f) { return std::max(bits(norm(f, 0)), 0L); }

long formal_degree(const flint::FmpzPoly& n, const flint::FmpzPoly& a, const flint::FmpzPoly& q) {
  return std::max(fmpz_poly_degree(a.get()),
                  fmpz_poly_degree(n.get()) - fmpz_poly_degree(q.get()) + 1);
}

long cofactor_bits(const flint::FmpzPoly& n, const flint::FmpzPoly& a, const flint::FmpzPoly& q) {
  const slong deg_q = fmpz_poly_degree(q.get());
  const slong deg_a = formal_degree(n, a, q);
  return least(q, [&](long s) {
    const Mag row = norm(a, s);
    Mag product;
    mag_max(product.get(), norm(n, s).get(), row.get());  // for n = a: the resultant itself
    multiply_by_power(product, row, deg_q - 1);
    multiply_by_power(product, norm(q, s), deg_a);
    return bits(product) - s * deg_a * deg_q + (s < 0 ? -s * (deg_q - 1) : 0);
  });
}

long residue_bits(const flint::FmpzPoly& n, const flint::FmpzPoly& d) {
  const slong size = fmpz_poly_degree(d.get());
  flint::FmpzPoly slope;
  fmpz_poly_derivative(slope.get(), d.get());
  return least(d, [&](long s) {
    Mag row = norm(n, s);
    mag_add(row.get(), row.get(), norm(slope, s).get());
    Mag product;
    mag_one(product.get());
    multiply_by_power(product, row, size);
    multiply_by_power(product, norm(d, s), size - 1);
    return bits(product) - s * size * (size - 1);
  });
}

}  // namespace phrame
