// If r is traced once, the map from y² = D(t) to the two-sided offset is birational but for
// finitely many d, and the genus of that curve is ⌈½ deg D⌉ − 1.
#include "phrame/ph/offset/conic_offset.hpp"

#include "phrame/algebra/decomposition.hpp"
#include "phrame/algebra/factor.hpp"
#include "phrame/algebra/real.hpp"
#include "phrame/algebra/rounding.hpp"
#include "phrame/ph/curve/vector.hpp"

namespace phrame::inline v0 {
namespace {

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
    const Polynomial h = fibre(curve);
    if (h.degree() <= 1) return found;
    if (const auto once = traced_once(curve, h)) {
      found = query.of_curve(*once);
      found.conic.reset();
      return found;
    }
    found.kind = Kind::undecided;
    return found;
  }
  const ConicParameters conic = query.conic();
  found.prime = conic.prime;
  found.radicand = conic.radicand;
  found.kind = conic.form || conic.prime != 0 ? Kind::two_sided : Kind::undecided;
  if (conic.form) found.conic = seen_from_outside(conic, squarefree);
  return found;
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
