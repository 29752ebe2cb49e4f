#include "phrame/ph/smooth/curve_series.hpp"

#include <algorithm>

namespace phrame {
namespace {

/// p(t + z) as a series in z, by Horner's rule.
BallPolynomial taylor_series(const Polynomial& p, const RealBall& t, long length, long bits) {
  const BallPolynomial shift({t, RealBall(1, bits)});
  BallPolynomial value;
  for (long k = p.degree(); k >= 0; --k) {
    value = multiply_series(value, shift, length, bits);
    value = with_constant(value, add(value.coefficient(0), RealBall(p.coefficient(k), bits), bits));
  }
  return value;
}

Vector<BallPolynomial> series_around(const RationalCurve& curve, const RealBall& t, long length,
                                     long bits) {
  const BallPolynomial weight = taylor_series(curve.weight(), t, length, bits);
  const bool is_polynomial = curve.weight() == Polynomial{1};
  Vector<BallPolynomial> r;
  for (std::size_t k = 0; k < 3; ++k) {
    r[k] = taylor_series(curve.numerator()[k], t, length, bits);
    if (!is_polynomial) r[k] = divide_series(r[k], weight, length, bits);
  }
  return r;
}

Vector<BallPolynomial> series_around(const ExpressionCurve& curve, const RealBall& t, long length,
                                     long bits) {
  return curve.series(t, 1, length, bits);
}

}  // namespace

CurveSeries series_of(const SmoothPath& path) {
  return {path.segments().size(),
          [path](std::size_t segment, const RealBall& t, long length, long bits) {
            return std::visit(
                [&](const auto& curve) { return series_around(curve, t, length, bits); },
                path.segments()[segment]);
          }};
}

CurveSeries series_of(const Path& path) { return series_of(by_positions(path)); }

}  // namespace phrame
