#include "phrame/ph/curve/curve_series.hpp"

#include <algorithm>
#include <memory>
#include <utility>
#include <variant>
#include <vector>

#include "phrame/algebra/ball_order.hpp"
#include "phrame/algebra/rounding.hpp"
#include "phrame/ph/curve/scale.hpp"
#include "phrame/ph/curve/special_points.hpp"
#include "phrame/ph/curve/vector.hpp"

namespace phrame::inline v0 {

// Of an interval it is that of the Taylor polynomial in the middle: the powers of t, which nearly
// cancel, would each be as wide as they are large.
BallPolynomial taylor_series(const Polynomial& p, const RealBall& t, long length, long bits) {
  const RealBall middle(t.midpoint(), 4096);
  const RealBall step = subtract(t, middle, bits);
  const BallPolynomial all(p, bits);
  if (step.is_zero() && length <= 2)  // by Horner's rule, faster than all coefficients
    return truncated(BallPolynomial(std::vector{evaluate(all, middle, bits),
                                                evaluate(differentiate(all, bits), middle, bits)}),
                     length);
  const BallPolynomial near = shifted(all, middle, bits);
  if (step.is_zero()) return truncated(near, length);
  const BallPolynomial shift({step, RealBall(1, bits)});
  BallPolynomial value;
  for (long k = p.degree(); k >= 0; --k) {
    value = multiply_series(value, shift, length, bits);
    value = with_constant(value, add(value.coefficient(0), near.coefficient(k), bits));
  }
  return value;
}

namespace {

/// An e with Σ|cₖ| < 2^e.
long exponent_of_terms(const Polynomial& p) {
  Rational sum = 0;
  for (const Rational& c : p.coefficients()) sum += abs(c);
  return exponent_above(RealBall(sum, 64));
}

/// So many bits, and those that p(t) loses where powers of t nearly cancel whose sum is below
/// 2^terms. Of several p that of the greatest p(t).
long working_bits(const std::vector<const Polynomial*>& polynomials, const RealBall& t, long terms,
                  long bits) {
  constexpr long most = 4096;
  const RealBall middle(t.midpoint(), 4096);
  for (long working = bits;; working *= 2) {
    long size = -unbounded_exponent;
    for (const Polynomial* p : polynomials)
      size = std::max(size, exponent_below(evaluate(*p, middle, working)));
    if (size != -unbounded_exponent) return bits + std::clamp(terms - size, 0L, most);
    if (working > most) return bits;
  }
}

/// r as r(0) + (X − r(0)W)/W. Quotients of balls are as wide as they are large: without r(0) that
/// is the size of the curve, wherever it lies.
struct CurveFromStart {
  Vector<Rational> start;
  Vector<Polynomial> numerator;
  Polynomial weight;
  long terms;  ///< with 2^terms above the powers of t in W, and in the numerator over its size

  explicit CurveFromStart(const RationalCurve& curve)
      : start(point(curve, 0)), numerator(curve.numerator()), weight(curve.weight()) {
    Rational size = 0;
    for (long k = 1; k <= 8; ++k)
      size = std::max(size, largest(point(curve, Rational(k, 8)) - start));
    terms = exponent_of_terms(weight);
    for (std::size_t k = 0; k < 3; ++k) {
      numerator[k] -= start[k] * weight;
      if (size != 0)
        terms = std::max(terms, exponent_of_terms(numerator[k]) - binary_exponent(size));
    }
  }
};

Vector<BallPolynomial> series_around(const CurveFromStart& curve, const RealBall& t, long length,
                                     long bits) {
  const long working = working_bits({&curve.weight}, t, curve.terms, bits);
  const BallPolynomial weight = taylor_series(curve.weight, t, length, working);
  const bool is_polynomial = curve.weight == Polynomial{1};
  Vector<BallPolynomial> r;
  for (std::size_t k = 0; k < 3; ++k) {
    r[k] = taylor_series(curve.numerator[k], t, length, working);
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

/// A function of a segment, whose copies share all of them.
template <class T, class F>
CurveSeries::Series series_of_each(std::vector<T> segments, F series) {
  return [shared = std::make_shared<const std::vector<T>>(std::move(segments)), series](
             std::size_t segment, const RealBall& t, long length, long bits) {
    return series((*shared)[segment], t, length, bits);
  };
}

/// Around the control points, where all weights are positive; else around nothing that is finite.
Vector<RealBall> box_around(const RationalCurve& curve) {
  constexpr long bits = 64;
  long degree = curve.weight().degree();
  for (const Polynomial& x : curve.numerator()) degree = std::max(degree, x.degree());
  const auto coefficients = [&](const Polynomial& p) {
    return to_bernstein(BallPolynomial(p, bits), degree, bits);
  };
  const std::vector<RealBall> weights = coefficients(curve.weight());
  const bool is_inside =
      std::ranges::all_of(weights, [](const RealBall& w) { return sign(w) > 0; });
  Vector<RealBall> box;
  for (std::size_t k = 0; k < 3; ++k) {
    const std::vector<RealBall> x = coefficients(curve.numerator()[k]);
    box[k] = divide(x[0], is_inside ? weights[0] : RealBall(), bits);
    for (std::size_t j = 1; j < x.size(); ++j)
      box[k] = hull(box[k], divide(x[j], weights[j], bits), bits);
  }
  return box;
}

SegmentTurning turning_of(const RationalCurve& curve) {
  const auto& [x, y, z] = curve.direction();
  const Polynomial turn = x * differentiate(y) - y * differentiate(x);
  SegmentTurning turning{sign_after_zero(curve.multiplier()),
                         sign_changes(curve.multiplier()),
                         sign_after_zero(turn),
                         {},
                         evaluate(curve.direction(), 0),
                         evaluate(curve.direction(), 1)};
  if (turning.first_turn != 0) turning.inflections = sign_changes(turn);
  return turning;
}

/// H times a power of 4, so that it and its products are in the range of doubles.
struct ScaledDirection {
  Vector<Polynomial> h;
  long terms;  ///< with 2^terms above the powers of t

  explicit ScaledDirection(const RationalCurve& curve) : h(curve.direction()) {
    const Rational scale = scale_for_doubles(largest({evaluate(h, 0), evaluate(h, 1)}));
    for (Polynomial& x : h) x *= scale;
    terms = std::max(exponent_of_terms(h[0]), exponent_of_terms(h[1]));
  }
};

Vector<BallPolynomial> series_around(const ScaledDirection& direction, const RealBall& t,
                                     long length, long bits) {
  const auto& [h, terms] = direction;
  const long working = working_bits({&h[0], &h[1]}, t, terms, bits);
  Vector<BallPolynomial> series;
  for (std::size_t k = 0; k < 3; ++k) series[k] = taylor_series(h[k], t, length, working);
  return series;
}

/// Does p vanish on [0, 1], and never change its sign inside?
bool goes_through_cusps(const Segment& segment) {
  const RationalCurve* curve = rational_curve(segment);
  if (curve == nullptr || curve->multiplier().degree() == 0) return false;
  const std::vector<RealRoot> found = cusps(segment);
  return !found.empty() && odd_inside(found).empty();
}

}  // namespace

CurveSeries series_of(const Path& path) {
  std::vector<SegmentSeries> segments;
  for (const auto& curve : path.segments())
    segments.push_back(visit_curve([](const auto& c) { return segment_of(c); }, curve));
  CurveSeries series;
  series.segments = segments.size();
  series.position = series_of_each(
      std::move(segments),
      [](const SegmentSeries& segment, const RealBall& t, long length, long bits) {
        return std::visit([&](const auto& curve) { return series_around(curve, t, length, bits); },
                          segment);
      });
  for (std::size_t k = 0; k < series.segments; ++k) {
    const Segment& segment = path.segments()[k];
    if (!goes_through_cusps(segment)) continue;
    const RationalCurve* curve = rational_curve(segment);
    series.through_cusps[k] =
        (orientation(segment) < 0 ? curve->turned_over() : *curve).direction();
  }
  return series;
}

Vector<BallPolynomial> along_motion(const CurveSeries& curve, std::size_t segment,
                                    const RealBall& t, const Vector<BallPolynomial>& position,
                                    long length, long bits) {
  const auto found = curve.through_cusps.find(segment);
  Vector<BallPolynomial> along;
  for (std::size_t k = 0; k < 3; ++k)
    along[k] = found == curve.through_cusps.end()
                   ? truncated(differentiate(position[k], bits), length)
                   : taylor_series(found->second[k], t, length, bits);
  return along;
}

CurveSeries plane_series(const std::vector<RationalCurve>& segments,
                         std::vector<std::size_t> behind) {
  CurveSeries series;
  series.segments = segments.size();
  series.behind = std::move(behind);
  std::vector<CurveFromStart> positions;
  std::vector<ScaledDirection> directions;
  for (const RationalCurve& curve : segments) {
    positions.emplace_back(curve);
    directions.emplace_back(curve);
    series.boxes.push_back(box_around(curve));
    series.turning.push_back(turning_of(curve));
  }
  const auto around = [](const auto& of_segment, const RealBall& t, long length, long bits) {
    return series_around(of_segment, t, length, bits);
  };
  series.position = series_of_each(std::move(positions), around);
  series.direction = series_of_each(std::move(directions), around);
  return series;
}

}  // namespace phrame
