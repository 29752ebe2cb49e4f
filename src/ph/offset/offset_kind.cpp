// |H| = |g|√D, where g has no real zero as H has none: with y² = D(t) the point r + d(H₂,
// −H₁)/(g·y) is the one to the right for y > 0 and the one to the left for y < 0. If r is traced
// once the map from that curve is birational but for finitely many d, and its genus is ⌈½ deg D⌉
// − 1.
#include "phrame/ph/offset/offset_kind.hpp"

#include <algorithm>

#include "phrame/algebra/decomposition.hpp"
#include "phrame/algebra/error.hpp"
#include "phrame/algebra/factor.hpp"
#include "phrame/algebra/gaussian_integer.hpp"
#include "phrame/algebra/real.hpp"
#include "phrame/algebra/rounding.hpp"
#include "phrame/ph/curve/vector.hpp"

namespace phrame::inline v0 {
namespace {

/// |H|² = squarefree·square², square > 0.
struct SplitNorm {
  Polynomial squarefree;
  Polynomial square;
};

SplitNorm split_norm(const Vector<Polynomial>& h) {
  const Factorization found = squarefree_factorization(dot(h, h));
  SplitNorm split{{1}, {1}};
  for (const Factor& factor : found.factors) {
    split.square *= pow(factor.base, factor.exponent / 2);
    if (factor.exponent % 2 != 0) split.squarefree *= factor.base;
  }
  // unit = rest·(root/denominator)²
  const Integer product = numerator(found.unit) * denominator(found.unit);
  const Integer rest = squarefree_rest(product);
  split.squarefree *= rest;
  split.square *= *square_root(Rational(product / rest)) / Rational(denominator(found.unit));
  if (split.square(0) < 0) split.square = -1 * split.square;
  return split;
}

/// h with r(t) = r(s) where h(t) = h(s), for all but finitely many s, of the least degree that some
/// s show: where it is 1 the curve is traced once.
Polynomial fibre(const RationalCurve& curve) {
  const Vector<Polynomial> x = curve.numerator();
  Polynomial least;
  for (long k = 2; k < 8 && (k == 2 || least.degree() > 1); ++k) {
    const Rational s(1, k);
    Polynomial common;
    for (const Polynomial& c : x)
      common = gcd(common, curve.weight()(s) * c - c(s) * curve.weight());
    if (least.is_zero() || common.degree() < least.degree()) least = common;
  }
  return least;
}

/// The curve by h(t), where it is polynomial.
std::optional<RationalCurve> traced_once(const RationalCurve& curve, const Polynomial& h) {
  Vector<Polynomial> outer;
  for (std::size_t k = 0; k < 3; ++k) {
    const auto found = outer_of(curve.numerator()[k], h);
    if (!found || !curve.weight().is_constant()) return std::nullopt;
    outer[k] = 1 / curve.weight().coefficient(0) * *found;
  }
  return RationalCurve(outer);
}

/// Of a curve in a plane z = const: D = |αt + β|² with β = −αρ, D(ρ) = 0, and α by one value of H.
/// As α and β span ℚ(i), αt + βs = 1 for some t and s, a point with y = 1. Nothing is factored.
ConicParameters conic_of(const Vector<Polynomial>& h, const SplitNorm& split) {
  const Polynomial& q = split.squarefree;
  const Rational a = q.coefficient(2);
  const Rational b = q.coefficient(1);
  const Rational c = q.coefficient(0);
  const auto root = square_root(4 * a * c - b * b);
  if (!h[2].is_zero() || !root || square_root(a) || square_root(c)) return conic_parameters(q);
  const GaussianRational to_root{b / (2 * a), -*root / (2 * a)};  // −ρ, of the norm c/a
  const Rational scale = a / (c * split.square(0));
  const GaussianRational alpha =
      GaussianRational{scale * h[0](0), scale * h[1](0)} * conjugate(to_root);
  const GaussianRational beta = alpha * to_root;
  const Rational t = beta.im;
  const Rational s = -alpha.im;
  const Rational y = alpha.re * t + beta.re * s;
  return s == 0 ? conic_parameters(q) : conic_through(q, t / s, y / s);
}

/// The same conic by lines through a point with t outside of [0, 1], or at infinity.
ConicParameters seen_from_outside(const ConicParameters& conic, const Polynomial& q) {
  if (!conic.base || (*conic.base)[0] < 0 || (*conic.base)[0] > 1) return conic;
  // m near √a is a point far away.
  const Real slope = square_root_of(q.coefficient(2));
  for (long bits = 4;; ++bits) {
    const Rational unit = power_of_two(-bits);
    const Rational m = unit * Rational(floor(slope.enclose(2 * bits + 64).midpoint() / unit));
    const auto& [t, y] = *conic.form;
    if (t.denominator()(m) == 0) continue;
    const Rational at = t(m);
    if (at < 0 || at > 1) return conic_through(q, at, y(m));
  }
}

/// m of the point with y > 0, or y < 0, at t.
Real parameter_of(const ConicParameters& conic, const Polynomial& q, const Rational& t, int sign) {
  const Real y = Rational(sign) * square_root_of(q(t));
  if (!conic.base) return y + -t * square_root_of(q.coefficient(2));
  const auto& [t0, y0] = *conic.base;
  return 1 / (t - t0) * (y + Real(-y0));
}

}  // namespace

OffsetKind offset_kind(const RationalCurve& curve) {
  using Kind = OffsetKind::Kind;
  const SplitNorm split = split_norm(curve.direction());
  OffsetKind found{Kind::none, split.squarefree};
  if (split.squarefree.is_constant()) {
    found.kind = Kind::each_side;
    found.radicand = numerator(split.squarefree.coefficient(0));
    return found;
  }
  if (split.squarefree.degree() > 2) {
    const Polynomial h = fibre(curve);
    if (h.degree() <= 1) return found;
    if (const auto once = traced_once(curve, h)) {
      found = offset_kind(*once);
      found.conic.reset();
      return found;
    }
    found.kind = Kind::undecided;
    return found;
  }
  const ConicParameters conic = conic_of(curve.direction(), split);
  found.prime = conic.prime;
  found.radicand = conic.radicand;
  found.kind = conic.form || conic.prime != 0 ? Kind::two_sided : Kind::undecided;
  if (conic.form) found.conic = seen_from_outside(conic, split.squarefree);
  return found;
}

TwoSidedOffset two_sided_offset(const RationalCurve& curve, const OffsetKind& kind,
                                const Rational& d, long digits) {
  const ConicParameters& conic = kind.conic.value();
  const RationalFunction& t = conic.form->front();
  const RationalFunction& y = conic.form->back();
  const SplitNorm split = split_norm(curve.direction());
  const auto of_m = [&](const Polynomial& p) { return compose(RationalFunction(p), t); };
  const RationalFunction length = of_m(split.square) * y;
  const RationalFunction step(d * length.denominator(), length.numerator());
  const auto coordinate = [&](std::size_t k, const Polynomial& across) {
    return compose(RationalFunction(curve.numerator()[k], curve.weight()), t) + step * of_m(across);
  };
  const RationalFunction x = coordinate(0, curve.direction()[1]);
  const RationalFunction v = coordinate(1, Rational(-1) * curve.direction()[0]);
  const Polynomial w = lcm(x.denominator(), v.denominator());
  TwoSidedOffset made{t,
                      {x.numerator() * exact_quotient(w, x.denominator()),
                       v.numerator() * exact_quotient(w, v.denominator())},
                      w,
                      {}};
  const Rational z = point(curve, 0)[2];
  for (const int sign : {1, -1}) {
    const auto end = [&](long at) {
      return parameter_of(conic, split.squarefree, at, sign).enclose(4 * digits + 64).midpoint();
    };
    const Rational unit = power_of_ten(-digits - 2);
    const Rational middle = (end(0) + end(1)) / 2;
    const auto inwards = [&](const Rational& m) -> Rational {
      const Rational steps(floor(m / unit));
      return unit * (m < middle ? steps + 1 : steps);
    };
    const Rational from = inwards(end(0));
    const Polynomial m{from, inwards(end(1)) - from};
    made.sides.push_back(RationalCurve(
        {compose(made.numerator[0], m), compose(made.numerator[1], m), z * compose(w, m)},
        compose(w, m)));
  }
  return made;
}

}  // namespace phrame
