#include "phrame/ph/curve/curve.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <ostream>

#include "phrame/algebra/error.hpp"
#include "phrame/algebra/in_place.hpp"
#include "phrame/algebra/power_series.hpp"
#include "phrame/ph/curve/hodograph_fraction.hpp"
#include "phrame/ph/curve/vector.hpp"

namespace phrame::inline v0 {

Curve::Curve(QuaternionPolynomial preimage, Polynomial multiplier)
    : Curve(std::move(preimage), std::move(multiplier), Vector<Rational>{}) {}

Curve::Curve(QuaternionPolynomial preimage, Polynomial multiplier, Vector<Rational> start)
    : preimage_(std::move(preimage)), multiplier_(std::move(multiplier)), start_(std::move(start)) {
  if (is_zero(preimage_)) throw DomainError("Curve: the preimage is zero, so the curve is a point");
  if (multiplier_.is_zero())
    throw DomainError("Curve: the multiplier is zero, so the curve is a point");
}

Curve Curve::quotient(QuaternionPolynomial preimage, Polynomial multiplier,
                      Vector<Polynomial> numerator, Polynomial weight) {
  Curve made(std::move(preimage), std::move(multiplier));
  const Rational w = weight(0);
  if (w == 0) throw DomainError("Curve: the weight function is 0 at t = 0");
  const Vector<Polynomial> rate = hodograph_numerator(made);
  const Polynomial slope = differentiate(weight);
  for (std::size_t k = 0; k < 3; ++k) {
    if (!(differentiate(numerator[k]) * weight - numerator[k] * slope == rate[k]))
      throw DomainError("Curve: f · A i A* is not X'W - XW'");
    made.start_[k] = numerator[k](0) / w;
  }
  if (weight.is_constant()) {
    made.multiplier_ *= 1 / (w * w);
    return made;
  }
  made.weight_ = std::move(weight);
  made.numerator_ = std::move(numerator);
  return made;
}

Curve Curve::with_form(QuaternionPolynomial preimage, Polynomial multiplier) const {
  Curve same = *this;
  same.preimage_ = std::move(preimage);
  same.multiplier_ = std::move(multiplier);
  return same;
}

long preimage_degree(const Curve& curve) { return degree(curve.preimage()); }

long degree(const Curve& curve) {
  if (curve.is_polynomial()) return 2 * preimage_degree(curve) + 1 + curve.multiplier().degree();
  long n = curve.weight().degree();
  for (const Polynomial& x : numerator(curve)) n = std::max(n, x.degree());
  return n;
}

namespace {

void require_polynomial(const Curve& curve, const char* function) {
  if (!curve.is_polynomial())
    throw DomainError(
        fmt::format("{}: the curve is rational, and this is of polynomial ones", function));
}

}  // namespace

Vector<Polynomial> hodograph_numerator(const Curve& curve) {
  Vector<Polynomial> result = rotated_i(curve.preimage());
  for (Polynomial& component : result) component *= curve.multiplier();
  return result;
}

Vector<Polynomial> hodograph(const Curve& curve) {
  require_polynomial(curve, "hodograph");
  return hodograph_numerator(curve);
}

Vector<Polynomial> numerator(const Curve& curve) {
  return curve.is_polynomial() ? position(curve) : curve.numerator_;
}

Vector<Polynomial> position(const Curve& curve) {
  require_polynomial(curve, "position");
  Vector<Polynomial> result = hodograph_numerator(curve);
  for (std::size_t k = 0; k < 3; ++k)
    result[k] = antiderivative(result[k]) + Polynomial{curve.start()[k]};
  return result;
}

Polynomial hodograph_content(const Curve& curve) {
  return gcd(hodograph_fraction(curve).numerator);
}

// The ends of isolating intervals and the middles between them meet every gap between two roots: an
// open interval has no root at its ends, and between two roots that are points is their middle.
Signs multiplier_signs(const Curve& curve) {
  const Polynomial& f = curve.multiplier();
  std::vector<Rational> samples{0};
  for (const Interval& root : isolate_real_roots(f, closed_interval(0, 1)))
    for (const Rational& end : {*root.lower, *root.upper}) {
      samples.push_back((samples.back() + end) / 2);
      samples.push_back(end);
    }
  samples.push_back((samples.back() + 1) / 2);
  samples.emplace_back(1);
  Signs signs;
  for (const Rational& t : samples) {
    const Rational value = f(t);
    signs.positive = signs.positive || value > 0;
    signs.negative = signs.negative || value < 0;
  }
  return signs;
}

Vector<Rational> evaluate(const Vector<Polynomial>& v, const Rational& t) {
  return {v[0](t), v[1](t), v[2](t)};
}

namespace {

constexpr long most_differences = 5;

}  // namespace

// With c_r = C(m, r) b_r and s = 1/t: Σ c_r tʳ (1 − t)^{m−r} = tᵐ Σ c_r (s − 1)^{m−r}, so reverse,
// substitute s → s − 1, reverse again: one Taylor shift.
Polynomial from_bernstein(const std::vector<Rational>& b) {
  const auto m = static_cast<long>(b.size()) - 1;
  if (0 <= m && m <= most_differences) return from_differences(b);
  std::vector<Rational> scaled = b;  // C(m, r)·b_r
  Rational binomial = 1;
  for (long r = 0; r <= m; ++r) {
    scaled[static_cast<std::size_t>(r)] *= binomial;
    binomial = binomial * (m - r) / (r + 1);
  }
  const Polynomial in_s = reversed(Polynomial(scaled), m + 1);  // c_m + c_{m−1} s + …
  return reversed(compose(in_s, Polynomial{-1, 1}), m + 1);     // s → s − 1, s = 1/t
}

Polynomial scaled_bernstein(const Polynomial& p, long m) {
  if (m < p.degree())
    throw DomainError(fmt::format("to_bernstein: degree {} is less than that of the polynomial, {}",
                                  m, p.degree()));
  // The inverse of the above: s → s + 1 on the reversed polynomial.
  return reversed(compose(reversed(p, m + 1), Polynomial{1, 1}), m + 1);
}

std::vector<Rational> to_bernstein(const Polynomial& p, long m) {
  const Polynomial scaled = scaled_bernstein(p, m);
  std::vector<Rational> b;
  Rational binomial = 1;
  for (long r = 0; r <= m; ++r) {
    b.push_back(scaled.coefficient(r) / binomial);
    binomial = binomial * (m - r) / (r + 1);
  }
  return b;
}

QuaternionPolynomial from_bernstein(const std::vector<RationalQuaternion>& b) {
  Quaternion<std::vector<Rational>> lists;
  for (const RationalQuaternion& a : b) {
    lists.u.push_back(a.u);
    lists.v.push_back(a.v);
    lists.p.push_back(a.p);
    lists.q.push_back(a.q);
  }
  return {from_bernstein(lists.u), from_bernstein(lists.v), from_bernstein(lists.p),
          from_bernstein(lists.q)};
}

std::vector<RationalQuaternion> to_bernstein(const QuaternionPolynomial& a, long m) {
  const auto u = to_bernstein(a.u, m);
  const auto v = to_bernstein(a.v, m);
  const auto p = to_bernstein(a.p, m);
  const auto q = to_bernstein(a.q, m);
  std::vector<RationalQuaternion> b;
  for (std::size_t k = 0; k < u.size(); ++k) b.push_back({u[k], v[k], p[k], q[k]});
  return b;
}

std::vector<Vector<Rational>> control_points(const Curve& curve) {
  const long n = degree(curve);
  std::vector<Vector<Rational>> points(static_cast<std::size_t>(n + 1));
  const Vector<Polynomial> r = position(curve);
  for (std::size_t k = 0; k < 3; ++k) {
    const auto b = to_bernstein(r[k], n);
    for (std::size_t j = 0; j < points.size(); ++j) points[j][k] = b[j];
  }
  return points;
}

// r′ = Σ n(P_{k+1} − P_k)·C(n − 1, k)(1 − t)^{n−1−k}tᵏ.
Vector<Polynomial> bezier_hodograph(const std::vector<Vector<Rational>>& points) {
  if (points.empty()) throw DomainError("bezier_hodograph: there are no control points");
  const std::size_t n = points.size() - 1;
  Vector<Polynomial> result;
  for (std::size_t k = 0; k < 3; ++k) {
    std::vector<Rational> steps;
    for (std::size_t j = 0; j < n; ++j)
      steps.emplace_back(static_cast<long>(n) * (points[j + 1][k] - points[j][k]));
    result[k] = from_bernstein(steps);
  }
  return result;
}

Curve turned_over(const Curve& curve) {
  const QuaternionPolynomial j{{}, {}, Polynomial{1}, {}};
  return curve.with_form(curve.preimage() * j, -curve.multiplier());
}

std::ostream& operator<<(std::ostream& out, const Curve& curve) {
  out << "A = " << curve.preimage() << ", f = " << curve.multiplier();
  if (!curve.is_polynomial()) out << ", W = " << curve.weight();
  return out << ", r(0) = " << curve.start();
}

}  // namespace phrame
