// |H| = |g|√D, where g has no real zero as H has none: with y² = D(t) the point r + d(H₂,
// −H₁)/(g·y) is the one to the right for y > 0 and the one to the left for y < 0.
#include "phrame/ph/offset/offset_kind.hpp"

#include "phrame/algebra/gaussian_integer.hpp"
#include "phrame/ph/curve/vector.hpp"
#include "phrame/ph/offset/conic_offset.hpp"

namespace phrame::inline v0 {
namespace {

SplitSquare split_norm(const RationalCurve& curve) {
  return split_square(dot(curve.direction(), curve.direction()));
}

/// Of a curve in a plane z = const: D = |αt + β|² with β = −αρ, D(ρ) = 0, and α by one value of H.
/// As α and β span ℚ(i), αt + βs = 1 for some t and s, a point with y = 1. Nothing is factored.
ConicParameters conic_of(const Vector<Polynomial>& h, const SplitSquare& split) {
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

}  // namespace

OffsetKind offset_kind(const RationalCurve& curve) {
  const SplitSquare split = split_norm(curve);
  return offset_kind_by(split.squarefree, curve,
                        {[](const RationalCurve& other) { return offset_kind(other); },
                         [&] { return conic_of(curve.direction(), split); }});
}

TwoSidedOffset two_sided_offset(const RationalCurve& traced, const OffsetKind& kind,
                                const Rational& d, long digits) {
  const RationalCurve& curve = traced_once(traced, kind);
  const auto& [t, y] = *kind.conic.value().form;
  const auto of_m = [&, &t = t](const Polynomial& p) { return compose(RationalFunction(p), t); };
  const RationalFunction length = of_m(split_norm(curve).square) * y;
  const RationalFunction factor(d * length.denominator(), length.numerator());
  const auto& [hx, hy, hz] = curve.direction();
  return two_sided_by(curve, kind, {factor * of_m(hy), factor * of_m(Rational(-1) * hx)}, 1,
                      digits);
}

}  // namespace phrame
