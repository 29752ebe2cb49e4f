// A = α + kβ in Hopf form is in a plane z = const where αβ̄ is real: where α = cu and β = cq with a
// common complex factor c, and u and q real. Then A = (u + qk)·c, and
//   A i A* = |c|²·(u + qk) i (u + qk)*.
// c is the greatest common divisor, times a number that makes the quotients real.
//
// Of a cubic σ = |w|² has degree 2, and least values at one t. There r″ is normal to r′, and
// r′ = −k(s − i)², as a complex number along the tangent there, with s = 0 at that t: so
// r = k(s + is² − s³/3) = 3a·(s − s³/3, −s²) turned, with a = k/3 = (2/3)|r′|²/|r″| and r″ along
// the axis.
#include "phrame/ph/curve/complex_form.hpp"

#include "phrame/algebra/gaussian_integer.hpp"
#include "phrame/ph/curve/invariants.hpp"
#include "phrame/ph/curve/shape.hpp"
#include "phrame/ph/curve/vector.hpp"

namespace phrame::inline v0 {

QuaternionPolynomial from_complex_root(const GaussianPolynomial& w) { return {w.re, {}, {}, w.im}; }

std::optional<ComplexForm> complex_form(const Curve& curve) {
  const QuaternionPolynomial& a = curve.preimage();
  if (a.v.is_zero() && a.p.is_zero()) return ComplexForm{curve.multiplier(), {a.u, a.q}};
  if (!rotated_i(a)[2].is_zero()) return std::nullopt;
  const auto [alpha, beta] = hopf_form(a);
  const GaussianPolynomial& some = is_zero(alpha) ? beta : alpha;
  GaussianPolynomial c = gcd(alpha, beta);
  const GaussianPolynomial rest = exact_quotient(some, c);
  const long n = degree(rest);
  c = GaussianPolynomial{{rest.re.coefficient(n)}, {rest.im.coefficient(n)}} * c;
  const Polynomial u = exact_quotient(alpha, c).re;
  const Polynomial q = exact_quotient(beta, c).re;
  const Rational content = common_content({u, q});
  return ComplexForm{Rational(content * content) * curve.multiplier() * norm(c),
                     {Rational(1 / content) * u, Rational(1 / content) * q}};
}

std::optional<TschirnhausenCubic> tschirnhausen_cubic(const Curve& curve) {
  const QuaternionPolynomial& a = curve.preimage();
  if (degree(curve) != 3 || !curve.multiplier().is_constant() || !plane_normal(a) ||
      line_direction(a))
    return std::nullopt;
  const Polynomial speed = sigma(a);
  const Rational at = -speed.coefficient(1) / (2 * speed.coefficient(2));
  const Vector<Polynomial> rate = hodograph(curve);
  const Vector<Rational> first = evaluate(rate, at);
  const Vector<Rational> second = evaluate(differentiate(rate), at);
  const Vector<Rational> vertex = evaluate(position(curve), at);
  const Vector<Rational> to_focus =
      Rational(Rational(2, 3) * dot(first, first) / dot(second, second)) * second;
  return TschirnhausenCubic{at, vertex, vertex + to_focus, dot(to_focus, to_focus)};
}

}  // namespace phrame
