#include "phrame/algebra/series_guess.hpp"

#include <algorithm>

// w = 1/√s has s·w′ = −s′w/2, and so
//   n·s₀·wₙ = −Σ (n − i/2)·sᵢ·wₙ₋ᵢ,  i = 1, …, min(n, deg s).
// Rounding errors spread as the solutions of the same equation with other right sides do, which on
// the disc of convergence are not much greater than w.

namespace phrame {
namespace {

/// Room for so many coefficients, which are 0.
BallPolynomial zeros(long length) {
  BallPolynomial p;
  arb_poly_fit_length(p.raw(), length);
  _arb_poly_set_length(p.raw(), length);
  for (slong k = 0; k < length; ++k) arb_zero(p.raw()->coeffs + k);
  return p;
}

void drop_radius(arb_struct* x) { mag_zero(arb_radref(x)); }

}  // namespace

BallPolynomial guess_inverse_sqrt(const BallPolynomial& s, long length, long bits) {
  const long degree = s.degree_bound();
  BallPolynomial ratio = zeros(degree + 1);     // sᵢ/s₀
  BallPolynomial weighted = zeros(degree + 1);  // i·sᵢ/(2s₀)
  for (long i = 1; i <= degree; ++i) {
    arb_struct* r = ratio.raw()->coeffs + i;
    arb_div(r, s.raw()->coeffs + i, s.raw()->coeffs, bits);
    drop_radius(r);
    arb_mul_si(weighted.raw()->coeffs + i, r, i, bits);
    arb_mul_2exp_si(weighted.raw()->coeffs + i, weighted.raw()->coeffs + i, -1);
    drop_radius(weighted.raw()->coeffs + i);
  }
  BallPolynomial series = zeros(length);
  arb_struct* w = series.raw()->coeffs;
  arb_rsqrt(w, s.raw()->coeffs, bits);
  drop_radius(w);
  RealBall sum;
  for (long n = 1; n < length; ++n) {
    const long terms = std::min(n, degree);
    arb_approx_dot(sum.raw(), nullptr, 0, weighted.raw()->coeffs + 1, 1, w + n - 1, -1, terms,
                   bits);
    arb_div_si(sum.raw(), sum.raw(), n, bits);
    drop_radius(sum.raw());
    arb_approx_dot(w + n, sum.raw(), 1, ratio.raw()->coeffs + 1, 1, w + n - 1, -1, terms, bits);
  }
  _arb_poly_normalise(series.raw());
  return series;
}

BallPolynomial guess_quotient(const BallPolynomial& p, const BallPolynomial& q, long length,
                              long bits) {
  const long degree = q.degree_bound();
  BallPolynomial ratio = zeros(degree + 1);  // qᵢ/q₀
  RealBall unit;
  arb_inv(unit.raw(), q.raw()->coeffs, bits);
  drop_radius(unit.raw());
  for (long i = 1; i <= degree; ++i)
    arb_approx_dot(ratio.raw()->coeffs + i, nullptr, 0, q.raw()->coeffs + i, 1, unit.raw(), 1, 1,
                   bits);
  BallPolynomial series = zeros(length);
  arb_struct* y = series.raw()->coeffs;
  RealBall first;
  for (long n = 0; n < length; ++n) {
    if (n < p.raw()->length)
      arb_approx_dot(first.raw(), nullptr, 0, p.raw()->coeffs + n, 1, unit.raw(), 1, 1, bits);
    else
      arb_zero(first.raw());
    arb_approx_dot(y + n, first.raw(), 1, ratio.raw()->coeffs + 1, 1, y + n - 1, -1,
                   std::min(n, degree), bits);
  }
  _arb_poly_normalise(series.raw());
  return series;
}

RealBall sum_of_sizes(const BallPolynomial& p) {
  flint::Mag sum;
  flint::Mag size;
  for (slong k = 0; k < p.raw()->length; ++k) {
    arb_get_mag(size.get(), p.raw()->coeffs + k);
    mag_add(sum.get(), sum.get(), size.get());
  }
  RealBall result;
  arf_set_mag(arb_midref(result.raw()), sum.get());
  return result;
}

}  // namespace phrame
