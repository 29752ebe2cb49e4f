#include "phrame/algebra/ball_series.hpp"

#include <algorithm>

#include "phrame/algebra/result_of.hpp"

namespace phrame::inline v0 {
namespace {

/// Every coefficient is unknown.
BallPolynomial unknown_ball_series(long length) {
  return BallPolynomial(
      std::vector<RealBall>(static_cast<std::size_t>(length), RealBall::unknown()));
}

}  // namespace

BallPolynomial truncated(BallPolynomial p, long length) {
  arb_poly_truncate(p.raw(), length);
  return p;
}

BallPolynomial multiply_series(const BallPolynomial& p, const BallPolynomial& q, long length,
                               long bits) {
  return result_of<BallPolynomial>(arb_poly_mullow, p.raw(), q.raw(), length, bits);
}

RealBall coefficient_of_product(const BallPolynomial& p, const BallPolynomial& q, long n,
                                long bits) {
  const long low = std::max(0L, n - q.degree_bound());
  const long high = std::min(n, p.degree_bound());
  RealBall sum;
  if (low <= high)
    arb_dot(sum.raw(), nullptr, 0, p.raw()->coeffs + low, 1, q.raw()->coeffs + (n - low), -1,
            high - low + 1, bits);
  return sum;
}

void set_coefficient(BallPolynomial& p, long k, const RealBall& c) {
  arb_poly_set_coeff_arb(p.raw(), k, c.raw());
}

BallPolynomial divide_series(const BallPolynomial& p, const BallPolynomial& q, long length,
                             long bits) {
  return result_of<BallPolynomial>(arb_poly_div_series, p.raw(), q.raw(), length, bits);
}

BallPolynomial inverse_sqrt_series(const BallPolynomial& p, long length, long bits) {
  return result_of<BallPolynomial>(arb_poly_rsqrt_series, p.raw(), length, bits);
}

CosSinSeries cos_sin_series(const BallPolynomial& p, long length, long bits) {
  CosSinSeries series;
  arb_poly_sin_cos_series(series.sin.raw(), series.cos.raw(), p.raw(), length, bits);
  return series;
}

BallPolynomial exp_series(const BallPolynomial& p, long length, long bits) {
  return result_of<BallPolynomial>(arb_poly_exp_series, p.raw(), length, bits);
}

BallPolynomial log_series(const BallPolynomial& p, long length, long bits) {
  if (sign(p.coefficient(0)) <= 0) return unknown_ball_series(length);
  return result_of<BallPolynomial>(arb_poly_log_series, p.raw(), length, bits);
}

BallPolynomial atan_series(const BallPolynomial& p, long length, long bits) {
  return result_of<BallPolynomial>(arb_poly_atan_series, p.raw(), length, bits);
}

BallPolynomial sqrt_series(const BallPolynomial& p, long length, long bits) {
  if (sign(p.coefficient(0)) <= 0) return unknown_ball_series(length);
  return result_of<BallPolynomial>(arb_poly_sqrt_series, p.raw(), length, bits);
}

BallPolynomial pow_series(const BallPolynomial& p, unsigned long k, long length, long bits) {
  return result_of<BallPolynomial>(arb_poly_pow_ui_trunc_binexp, p.raw(), k, length, bits);
}

}  // namespace phrame
