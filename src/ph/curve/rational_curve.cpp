#include "phrame/ph/curve/rational_curve.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "phrame/algebra/as_written.hpp"
#include "phrame/algebra/compact.hpp"
#include "phrame/algebra/error.hpp"
#include "phrame/ph/curve/vector.hpp"

namespace phrame::inline v0 {
namespace {

Vector<Polynomial> quotient(const Vector<Polynomial>& v, const Polynomial& by) {
  return {exact_quotient(v[0], by), exact_quotient(v[1], by), exact_quotient(v[2], by)};
}

/// ∫₀ᵗ p·h.
Polynomial integral(const Polynomial& p, const Polynomial& h) {
  return p.is_constant() ? p.coefficient(0) * antiderivative(h) : antiderivative(p * h);
}
Rational integral(const Polynomial& p, const Polynomial& h, const Rational& t) {
  return p.is_constant() ? p.coefficient(0) * antiderivative(h)(t) : antiderivative(p * h)(t);
}

void refuse_zeros(const Polynomial& weight) {
  const std::vector<Interval> zeros = located_real_roots(weight, closed_interval(0, 1));
  if (zeros.empty()) return;
  const Interval& first = zeros.front();
  throw DomainError(
      first.lower == first.upper
          ? fmt::format("the weight function is 0 at t = {}", as_written(*first.lower))
          : fmt::format("the weight function is 0 near t = {:.6g}",
                        static_cast<double>((*first.lower + *first.upper) / 2)));
}

}  // namespace

RationalCurve::RationalCurve(const Vector<Polynomial>& numerator, const Polynomial& weight) {
  if (weight.is_zero()) throw DomainError("the weight function is 0");
  if (weight.is_constant()) {
    numerator_ = weight == Polynomial{1} ? numerator : quotient(numerator, weight);
    weight_ = {1};
  } else {
    const Polynomial common = gcd(gcd(numerator), weight);
    numerator_ = quotient(numerator, common);
    weight_ = exact_quotient(weight, common);
    refuse_zeros(weight_);
    const Rational unit = Rational(sign_after_zero(weight_)) / abs(content(weight_));
    if (unit != 1) {
      weight_ *= unit;
      for (Polynomial& x : numerator_) x *= unit;
    }
  }

  Vector<Polynomial> hodograph = differentiate(numerator_);
  if (const Polynomial slope = differentiate(weight_); !slope.is_zero())
    for (std::size_t k = 0; k < 3; ++k)
      hodograph[k] = hodograph[k] * weight_ - numerator_[k] * slope;
  multiplier_ = gcd(hodograph);
  if (multiplier_.is_zero())
    throw DomainError(fmt::format("the curve is the point {}", abbreviated(point(*this, 0))));
  direction_ = multiplier_ == Polynomial{1} ? hodograph : quotient(hodograph, multiplier_);
  Rational scale = common_content({direction_[0], direction_[1], direction_[2]});
  if (sign_after_zero(multiplier_) < 0) scale = -scale;
  for (Polynomial& x : direction_) x *= Rational(1) / scale;
  multiplier_ *= scale;

  if (weight_.is_constant())
    for (Polynomial& x : numerator_) x = Polynomial{x.coefficient(0)};
  for (Vector<Polynomial>* v : {&numerator_, &direction_})
    for (Polynomial& x : *v) x = compact(std::move(x));
}

Vector<Polynomial> RationalCurve::numerator() const {
  if (!weight_.is_constant()) return numerator_;
  Vector<Polynomial> X = numerator_;
  for (std::size_t k = 0; k < 3; ++k) X[k] += integral(multiplier_, direction_[k]);
  return X;
}

RationalCurve RationalCurve::turned_over() const {
  RationalCurve other = *this;
  for (Polynomial& x : other.direction_) x = -x;
  other.multiplier_ = -other.multiplier_;
  return other;
}

long degree(const RationalCurve& curve) {
  long degree = curve.weight().degree();
  for (const Polynomial& x : curve.numerator()) degree = std::max(degree, x.degree());
  return degree;
}

Vector<Polynomial> hodograph(const RationalCurve& curve) {
  return curve.multiplier() * curve.direction();
}

Vector<Polynomial> binormal(const RationalCurve& curve) {
  return cross(curve.direction(), differentiate(curve.direction()));
}

Vector<Rational> point(const RationalCurve& curve, const Rational& t) {
  Vector<Rational> r = evaluate(curve.numerator_, t);
  if (curve.weight_.is_constant()) {
    for (std::size_t k = 0; t != 0 && k < 3; ++k)
      r[k] += integral(curve.multiplier_, curve.direction_[k], t);
    return r;
  }
  const Rational w = curve.weight_(t);
  for (Rational& x : r) x /= w;
  return r;
}

RationalCurve bezier_curve(const std::vector<Vector<Rational>>& points,
                           const std::vector<Rational>& weights) {
  if (points.empty()) throw DomainError("a Bézier curve has at least one control point");
  if (!weights.empty() && weights.size() != points.size())
    throw DomainError(
        fmt::format("{} weights for {} control points", weights.size(), points.size()));
  Vector<Polynomial> numerator;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    std::vector<Rational> b;
    for (std::size_t k = 0; k < points.size(); ++k)
      b.push_back(weights.empty() ? points[k][axis] : weights[k] * points[k][axis]);
    numerator[axis] = from_bernstein(b);
  }
  return RationalCurve(numerator, weights.empty() ? Polynomial{1} : from_bernstein(weights));
}

}  // namespace phrame
