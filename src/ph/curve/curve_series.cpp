#include "phrame/ph/curve/curve_series.hpp"

#include <utility>
#include <variant>
#include <vector>

namespace phrame {
namespace {

/// p(t + z) as a series in z, by Horner's rule.
BallPolynomial taylor_series(const Polynomial& p, const RealBall& t, long length, long bits) {
  const BallPolynomial shift({t, RealBall(1, bits)});
  const BallPolynomial near(p, bits);
  BallPolynomial value;
  for (long k = p.degree(); k >= 0; --k) {
    value = multiply_series(value, shift, length, bits);
    value = with_constant(value, add(value.coefficient(0), near.coefficient(k), bits));
  }
  return value;
}

/// r as r(0) + (X − r(0)W)/W. Quotients of balls are as wide as they are large: without r(0) that
/// is the size of the curve, wherever it lies.
struct CurveFromStart {
  Vector<Rational> start;
  Vector<Polynomial> numerator;
  Polynomial weight;

  explicit CurveFromStart(const RationalCurve& curve)
      : start(point(curve, 0)), numerator(curve.numerator()), weight(curve.weight()) {
    for (std::size_t k = 0; k < 3; ++k) numerator[k] -= start[k] * weight;
  }
};

Vector<BallPolynomial> series_around(const CurveFromStart& curve, const RealBall& t, long length,
                                     long bits) {
  const BallPolynomial weight = taylor_series(curve.weight, t, length, bits);
  const bool is_polynomial = curve.weight == Polynomial{1};
  Vector<BallPolynomial> r;
  for (std::size_t k = 0; k < 3; ++k) {
    r[k] = taylor_series(curve.numerator[k], t, length, bits);
    if (!is_polynomial) r[k] = divide_series(r[k], weight, length, bits);
    r[k] = with_constant(r[k], add(r[k].coefficient(0), RealBall(curve.start[k], bits), bits));
  }
  return r;
}

using SegmentSeries = std::variant<CurveFromStart, ExpressionCurve>;

SegmentSeries segment_of(const RationalCurve& curve) { return CurveFromStart(curve); }
SegmentSeries segment_of(const ExpressionCurve& curve) { return curve; }

Vector<BallPolynomial> series_around(const ExpressionCurve& curve, const RealBall& t, long length,
                                     long bits) {
  return curve.series(t, 1, length, bits);
}

}  // namespace

CurveSeries series_of(const Path& path) {
  std::vector<SegmentSeries> segments;
  for (const auto& curve : path.segments())
    segments.push_back(visit_curve([](const auto& c) { return segment_of(c); }, curve));
  const std::size_t count = segments.size();
  return {count, [segments = std::move(segments)](std::size_t segment, const RealBall& t,
                                                  long length, long bits) {
            return std::visit(
                [&](const auto& curve) { return series_around(curve, t, length, bits); },
                segments[segment]);
          }};
}

}  // namespace phrame
