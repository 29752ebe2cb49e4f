#include "phrame/algebra/complex_series.hpp"

namespace phrame::inline v0 {
namespace {

/// Every coefficient is unknown.
ComplexSeries unknown_series(long length) {
  return ComplexSeries(
      std::vector<ComplexBall>(static_cast<std::size_t>(length), ComplexBall::unknown()));
}

/// Is the principal logarithm, with a cut along (−∞, 0], analytic on the first coefficient?
bool is_off_negative_axis(const ComplexSeries& p) {
  const ComplexBall z = p.coefficient(0);
  return sign(z.re()) > 0 || sign(z.im()) != 0;
}

/// Is the principal arctangent, with cuts from ±i along the imaginary axis, analytic there?
bool is_off_imaginary_cuts(const ComplexSeries& p) {
  const ComplexBall z = p.coefficient(0);
  const RealBall height = absolute(z.im());
  return sign(z.re()) != 0 || sign(subtract(RealBall(1, 2), height, 64)) > 0;
}

}  // namespace

ComplexSeries::ComplexSeries(const std::vector<ComplexBall>& ascending) {
  for (std::size_t k = 0; k < ascending.size(); ++k)
    acb_poly_set_coeff_acb(raw(), static_cast<slong>(k), ascending[k].raw());
}

ComplexBall ComplexSeries::coefficient(long k) const {
  ComplexBall c;
  acb_poly_get_coeff_acb(c.raw(), raw(), k);
  return c;
}

ComplexSeries add(const ComplexSeries& p, const ComplexSeries& q, long bits) {
  ComplexSeries sum;
  acb_poly_add(sum.raw(), p.raw(), q.raw(), bits);
  return sum;
}

ComplexSeries multiply(const RealBall& c, const ComplexSeries& p, long bits) {
  ComplexSeries product;
  acb_poly_scalar_mul(product.raw(), p.raw(), ComplexBall(c, {}).raw(), bits);
  return product;
}

ComplexSeries multiply_series(const ComplexSeries& p, const ComplexSeries& q, long length,
                              long bits) {
  ComplexSeries product;
  acb_poly_mullow(product.raw(), p.raw(), q.raw(), length, bits);
  return product;
}

ComplexSeries divide_series(const ComplexSeries& p, const ComplexSeries& q, long length,
                            long bits) {
  ComplexSeries quotient;
  acb_poly_div_series(quotient.raw(), p.raw(), q.raw(), length, bits);
  return quotient;
}

ComplexSeries exp_series(const ComplexSeries& p, long length, long bits) {
  ComplexSeries series;
  acb_poly_exp_series(series.raw(), p.raw(), length, bits);
  return series;
}

ComplexSeries log_series(const ComplexSeries& p, long length, long bits) {
  if (!is_off_negative_axis(p)) return unknown_series(length);
  ComplexSeries series;
  acb_poly_log_series(series.raw(), p.raw(), length, bits);
  return series;
}

ComplexSeries atan_series(const ComplexSeries& p, long length, long bits) {
  if (!is_off_imaginary_cuts(p)) return unknown_series(length);
  ComplexSeries series;
  acb_poly_atan_series(series.raw(), p.raw(), length, bits);
  return series;
}

ComplexSeries sqrt_series(const ComplexSeries& p, long length, long bits) {
  if (!is_off_negative_axis(p)) return unknown_series(length);
  ComplexSeries series;
  acb_poly_sqrt_series(series.raw(), p.raw(), length, bits);
  return series;
}

ComplexSeries pow_series(const ComplexSeries& p, unsigned long k, long length, long bits) {
  ComplexSeries series;
  acb_poly_pow_ui_trunc_binexp(series.raw(), p.raw(), k, length, bits);
  return series;
}

ComplexCosSinSeries cos_sin_series(const ComplexSeries& p, long length, long bits) {
  ComplexCosSinSeries series;
  acb_poly_sin_cos_series(series.sin.raw(), series.cos.raw(), p.raw(), length, bits);
  return series;
}

}  // namespace phrame
