// If r is traced once, the map from y² = D(t) to the two-sided offset is birational but for
// finitely many d, and the genus of that curve is ⌈½ deg D⌉ − 1.
#include "phrame/ph/offset/conic_offset.hpp"

#include <algorithm>

#include "phrame/algebra/factor.hpp"
#include "phrame/algebra/real.hpp"
#include "phrame/algebra/rounding.hpp"
#include "phrame/ph/curve/special_points.hpp"
#include "phrame/ph/curve/vector.hpp"

namespace phrame::inline v0 {
namespace {

/// The t with r(t) = r(s), as the zeros of a polynomial; no value where t = ∞ is one of them.
std::optional<Polynomial> fibre(const RationalCurve& curve, const Rational& s) {
  const Polynomial& w = curve.weight();
  Polynomial common;
  bool is_finite = false;
  for (const Polynomial& x : curve.numerator()) {
    const Polynomial difference = w(s) * x - x(s) * w;
    common = gcd(common, difference);
    is_finite = is_finite || difference.degree() == degree(curve);
  }
  return is_finite ? std::optional(common) : std::nullopt;
}

/// h = p/q, of which r is a function, r(t) = R(h(t)), traced once by that.
struct Tracing {
  Polynomial p;
  Polynomial q;
};

/// For all but finitely many s the fibre through s is that of h, p(t)·q(s) − q(t)·p(s) [Lüroth],
/// others have more points: of the least degree that some s show, h is the quotient of two.
std::optional<Tracing> tracing(const RationalCurve& curve) {
  std::optional<Polynomial> p;
  for (long k = 2; k < 10 && (!p || p->degree() > 1); ++k)
    if (auto found = fibre(curve, Rational(1, k)); found && (!p || found->degree() < p->degree()))
      p = std::move(found);
  if (!p) return std::nullopt;
  if (p->degree() == 1) return Tracing{{0, 1}, {1}};
  if (curve.weight().is_constant()) return Tracing{*p, {1}};
  std::optional<Polynomial> q;
  for (long k = 2; k < 10; ++k)
    for (const Rational& s : {Rational(k), Rational(1 - k)}) {
      auto found = fibre(curve, s);
      if (!found || found->degree() != p->degree() || (*found)(0) == 0) continue;
      if (((*p)(0) * *found - (*found)(0) * *p).is_zero()) continue;
      const bool is_beside = real_roots(*found, closed_interval(0, 1)).empty();
      if (is_beside) return Tracing{*p, *std::move(found)};
      if (!q) q = std::move(found);
    }
  return q ? std::optional(Tracing{*p, *std::move(q)}) : std::nullopt;
}

/// Σ cᵢ·pⁱ·qⁿ⁻ⁱ
Polynomial composed(const std::vector<Rational>& c, const Tracing& h) {
  Polynomial sum;
  Polynomial q{1};
  for (std::size_t i = c.size(); i-- > 0; q *= h.q) sum = sum * h.p + c[i] * q;
  return sum;
}

/// The cᵢ, i ≤ n, of which that is x, by its values at n + 1 places and Newton's differences.
std::optional<Polynomial> outer_of(const Polynomial& x, const Tracing& h, long n) {
  const Polynomial scale = pow(h.q, n);
  std::vector<Rational> at;
  std::vector<Rational> values;
  for (long t = 1; static_cast<long>(at.size()) <= n; ++t) {
    const Rational q = h.q(t);
    if (q == 0 || std::ranges::find(at, h.p(t) / q) != at.end()) continue;
    at.push_back(h.p(t) / q);
    values.push_back(x(t) / scale(t));
  }
  for (std::size_t k = 1; k < at.size(); ++k)
    for (std::size_t i = at.size() - 1; i >= k; --i)
      values[i] = (values[i] - values[i - 1]) / (at[i] - at[i - k]);
  Polynomial outer;
  for (std::size_t i = at.size(); i-- > 0;)
    outer = outer * Polynomial{-at[i], 1} + Polynomial{values[i]};
  std::vector<Rational> c;
  for (long i = 0; i <= n; ++i) c.push_back(outer.coefficient(i));
  return composed(c, h) == x ? std::optional(outer) : std::nullopt;
}

/// The curve by h from t = 0 to t = `end`, where h goes one way on that.
std::optional<TracedOnce> traced_once(const Vector<Polynomial>& x, const Polynomial& w,
                                      const Tracing& h, const Rational& end) {
  const auto& [p, q] = h;
  const Polynomial slope = differentiate(p) * q - p * differentiate(q);
  if (!real_roots(q, closed_interval(0, end)).empty() ||
      !sign_changes(compose(slope, Polynomial{0, end})).empty())
    return std::nullopt;
  const Rational from = p(0) / q(0);
  const Rational step = p(end) / q(end) - from;
  const auto by_s = [&](const Polynomial& y) { return compose(y, Polynomial{from, step}); };
  return TracedOnce{RationalFunction(p - from * q, step * q),
                    RationalCurve({by_s(x[0]), by_s(x[1]), by_s(x[2])}, by_s(w))};
}

/// Of a curve that is traced several times: it as far as h goes one way, and that t.
struct Once {
  TracedOnce curve;
  Rational end;
};
std::optional<Once> part_traced_once(const RationalCurve& curve, const Tracing& h) {
  const long n = degree(curve) / std::max(h.p.degree(), h.q.degree());
  const auto w = outer_of(curve.weight(), h, n);
  Vector<Polynomial> x;
  for (std::size_t k = 0; k < 3; ++k) {
    const auto found = outer_of(curve.numerator()[k], h, n);
    if (!found || !w) return std::nullopt;
    x[k] = *found;
  }
  for (Rational end = 1;; end /= 2)
    if (auto found = traced_once(x, *w, h, end)) return Once{*std::move(found), end};
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

SplitSquare split_square(const Polynomial& q) {
  const Factorization found = squarefree_factorization(q);
  SplitSquare split{{1}, {1}};
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

OffsetKind offset_kind_by(const Polynomial& squarefree, const RationalCurve& curve,
                          const OffsetKindQuery& query) {
  using Kind = OffsetKind::Kind;
  OffsetKind found{Kind::none, squarefree};
  if (squarefree.is_constant()) {
    found.kind = Kind::each_side;
    found.radicand = numerator(squarefree.coefficient(0));
    return found;
  }
  if (squarefree.degree() > 2) {
    const auto h = tracing(curve);
    if (h && h->p.degree() == 1) return found;
    auto once = h ? part_traced_once(curve, *h) : std::nullopt;
    if (!once) {
      found.kind = Kind::undecided;
      return found;
    }
    found = query.of_curve(once->curve.curve);
    if (once->end == 1)
      found.once = std::move(once->curve);
    else
      found.conic.reset();
    return found;
  }
  const ConicParameters conic = query.conic();
  found.prime = conic.prime;
  found.radicand = conic.radicand;
  found.kind = conic.form || conic.prime != 0 ? Kind::two_sided : Kind::undecided;
  if (conic.form) found.conic = seen_from_outside(conic, squarefree);
  return found;
}

const RationalCurve& traced_once(const RationalCurve& curve, const OffsetKind& kind) {
  return kind.once ? kind.once->curve : curve;
}

TwoSidedOffset two_sided_by(const RationalCurve& curve, const OffsetKind& kind,
                            const std::array<RationalFunction, 2>& step, int first, long digits) {
  const ConicParameters& conic = *kind.conic;
  const RationalFunction& t = conic.form->front();
  const auto coordinate = [&](std::size_t k) {
    return compose(RationalFunction(curve.numerator()[k], curve.weight()), t) + step[k];
  };
  const RationalFunction x = coordinate(0);
  const RationalFunction v = coordinate(1);
  const Polynomial w = lcm(x.denominator(), v.denominator());
  TwoSidedOffset made{t,
                      kind.once ? std::optional(kind.once->parameter) : std::nullopt,
                      {x.numerator() * exact_quotient(w, x.denominator()),
                       v.numerator() * exact_quotient(w, v.denominator())},
                      w,
                      {},
                      {}};
  const Rational z = point(curve, 0)[2];
  for (const int sign : {first, -first}) {
    const auto end = [&](long at) {
      return parameter_of(conic, kind.squarefree, at, sign).enclose(4 * digits + 64).midpoint();
    };
    const Rational unit = power_of_ten(-digits - 2);
    const Rational middle = (end(0) + end(1)) / 2;
    const auto inwards = [&](const Rational& m) -> Rational {
      const Rational steps(floor(m / unit));
      return unit * (m < middle ? steps + 1 : steps);
    };
    const Rational from = inwards(end(0));
    const Rational to = inwards(end(1));
    const Polynomial m{from, to - from};
    made.ends.push_back({from, to});
    made.sides.push_back(RationalCurve(
        {compose(made.numerator[0], m), compose(made.numerator[1], m), z * compose(w, m)},
        compose(w, m)));
  }
  return made;
}

}  // namespace phrame
