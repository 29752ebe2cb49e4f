#include "phrame/algebra/complex_series.hpp"

#include <algorithm>

#include "phrame/algebra/result_of.hpp"

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
  return result_of<ComplexBall>(acb_poly_get_coeff_acb, raw(), k);
}

// Each coefficient is what p leaves when it is divided by t − z once more, by Horner's rule.
ComplexSeries series_at(const BallPolynomial& p, const ComplexBall& z, long length, long bits) {
  std::vector<ComplexBall> quotient;
  for (long k = 0; k <= p.degree_bound(); ++k) quotient.emplace_back(p.coefficient(k), RealBall());
  const std::size_t count = std::min(static_cast<std::size_t>(length), quotient.size());
  for (std::size_t j = 0; j < count; ++j)
    for (std::size_t k = quotient.size() - 1; k > j; --k)
      acb_addmul(quotient[k - 1].raw(), quotient[k].raw(), z.raw(), bits);
  quotient.resize(count);
  return ComplexSeries(quotient);
}

ComplexSeries without_constant(const ComplexSeries& p) {
  return result_of<ComplexSeries>(acb_poly_shift_right, p.raw(), 1);
}

ComplexSeries add(const ComplexSeries& p, const ComplexSeries& q, long bits) {
  return result_of<ComplexSeries>(acb_poly_add, p.raw(), q.raw(), bits);
}

ComplexSeries multiply(const RealBall& c, const ComplexSeries& p, long bits) {
  return result_of<ComplexSeries>(acb_poly_scalar_mul, p.raw(), ComplexBall(c, {}).raw(), bits);
}

ComplexSeries multiply_series(const ComplexSeries& p, const ComplexSeries& q, long length,
                              long bits) {
  return result_of<ComplexSeries>(acb_poly_mullow, p.raw(), q.raw(), length, bits);
}

ComplexSeries divide_series(const ComplexSeries& p, const ComplexSeries& q, long length,
                            long bits) {
  return result_of<ComplexSeries>(acb_poly_div_series, p.raw(), q.raw(), length, bits);
}

ComplexSeries exp_series(const ComplexSeries& p, long length, long bits) {
  return result_of<ComplexSeries>(acb_poly_exp_series, p.raw(), length, bits);
}

ComplexSeries log_series(const ComplexSeries& p, long length, long bits) {
  if (!is_off_negative_axis(p)) return unknown_series(length);
  return result_of<ComplexSeries>(acb_poly_log_series, p.raw(), length, bits);
}

ComplexSeries atan_series(const ComplexSeries& p, long length, long bits) {
  if (!is_off_imaginary_cuts(p)) return unknown_series(length);
  return result_of<ComplexSeries>(acb_poly_atan_series, p.raw(), length, bits);
}

ComplexSeries sqrt_series(const ComplexSeries& p, long length, long bits) {
  if (!is_off_negative_axis(p)) return unknown_series(length);
  return result_of<ComplexSeries>(acb_poly_sqrt_series, p.raw(), length, bits);
}

ComplexSeries pow_series(const ComplexSeries& p, unsigned long k, long length, long bits) {
  return result_of<ComplexSeries>(acb_poly_pow_ui_trunc_binexp, p.raw(), k, length, bits);
}

ComplexCosSinSeries cos_sin_series(const ComplexSeries& p, long length, long bits) {
  ComplexCosSinSeries series;
  acb_poly_sin_cos_series(series.sin.raw(), series.cos.raw(), p.raw(), length, bits);
  return series;
}

}  // namespace phrame
