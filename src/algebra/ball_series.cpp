#include "phrame/algebra/ball_series.hpp"

namespace phrame {

BallPolynomial multiply_series(const BallPolynomial& p, const BallPolynomial& q, long length,
                               long bits) {
  BallPolynomial product;
  arb_poly_mullow(product.raw(), p.raw(), q.raw(), length, bits);
  return product;
}

BallPolynomial divide_series(const BallPolynomial& p, const BallPolynomial& q, long length,
                             long bits) {
  BallPolynomial quotient;
  arb_poly_div_series(quotient.raw(), p.raw(), q.raw(), length, bits);
  return quotient;
}

BallPolynomial inverse_sqrt_series(const BallPolynomial& p, long length, long bits) {
  BallPolynomial series;
  arb_poly_rsqrt_series(series.raw(), p.raw(), length, bits);
  return series;
}

CosSinSeries cos_sin_series(const BallPolynomial& p, long length, long bits) {
  CosSinSeries series;
  arb_poly_sin_cos_series(series.sin.raw(), series.cos.raw(), p.raw(), length, bits);
  return series;
}

}  // namespace phrame
