// In general gcd(f·A i A*) may have a factor of the denominator of f: then r has the weight W with
// f·W² no polynomial. With W times the denominator of f·W² for W it is one.
//
// Of a family of lines, with D = a² + b² and δ = a′b − ab′: n = (2ab, a² − b²)/D, n′ = (2δ/D)·m
// with m = (b² − a², 2ab)/D, a unit vector across n, and n·r = p, n′·r = p′ give
//   r = p·n + p′·D/(2δ)·m,
// of which r′ is along m = (b + ia)²/D as a complex number, w = b + ia: A = b + a·k.
#include "phrame/ph/curve/rational_ph.hpp"

#include <fmt/format.h>

#include "phrame/algebra/error.hpp"
#include "phrame/algebra/real_algebraic.hpp"
#include "phrame/integrate/integrate.hpp"
#include "phrame/ph/curve/complex_form.hpp"
#include "phrame/ph/curve/rational_curve.hpp"
#include "phrame/ph/curve/vector.hpp"

namespace phrame::inline v0 {
namespace {

void refuse_poles(const Polynomial& denominator, const char* what) {
  const auto poles = real_roots(denominator, closed_interval(0, 1));
  if (!poles.empty())
    throw DomainError(fmt::format("{} at {}", what, place_text("t", poles.front().at)));
}

/// Its components over their least common denominator, the weight.
Curve over_one_weight(const QuaternionPolynomial& preimage, const RationalFunction& multiplier,
                      const Vector<RationalFunction>& r) {
  Polynomial weight{1};
  for (const RationalFunction& x : r) weight = lcm(weight, x.denominator());
  // f·W² as a polynomial.
  weight *= (multiplier * RationalFunction(weight * weight)).denominator();
  if (weight(0) < 0) weight = -weight;
  Vector<Polynomial> numerator;
  for (std::size_t k = 0; k < 3; ++k)
    numerator[k] = r[k].numerator() * exact_quotient(weight, r[k].denominator());
  Polynomial f = (multiplier * RationalFunction(weight * weight)).numerator();
  return Curve::quotient(preimage, std::move(f), std::move(numerator), std::move(weight));
}

}  // namespace

Curve rational_ph_curve(const QuaternionPolynomial& preimage, const RationalFunction& multiplier,
                        const Vector<Rational>& start) {
  if (multiplier.is_polynomial()) return Curve(preimage, multiplier.numerator(), start);
  refuse_poles(multiplier.denominator(), "the multiplier has a pole");
  const Vector<Polynomial> along = rotated_i(preimage);
  Vector<RationalFunction> r;
  for (std::size_t k = 0; k < 3; ++k) {
    const auto [F, rest] = algebraic_part(multiplier * RationalFunction(along[k]));
    if (!rest.is_zero())
      throw DomainError(fmt::format("{} has a logarithm: its residues at the roots of {} are not 0",
                                    "xyz"[k], abbreviated(to_string(rest.denominator()), 120)));
    r[k] = RationalFunction(F.polynomial) + F.rational;
    r[k] = r[k] + RationalFunction(Polynomial{start[k] - r[k](0)});
  }
  return over_one_weight(preimage, multiplier, r);
}

Curve curve_of_tangents(const TangentLines& lines) {
  const auto& [a, b, p] = lines;
  if (!gcd(a, b).is_constant()) throw DomainError("tangents: a and b have a common factor");
  const Polynomial size = a * a + b * b;
  const Polynomial turn = differentiate(a) * b - a * differentiate(b);
  if (turn.is_zero())
    throw DomainError("tangents: the normal does not turn, the lines are parallel");
  const Vector<RationalFunction> n{
      RationalFunction(Rational(2) * a * b, size), RationalFunction(a * a - b * b, size), {}};
  const RationalFunction way = differentiate(p) * RationalFunction(size, Rational(2) * turn);
  const Vector<RationalFunction> r{p * n[0] - way * n[1], p * n[1] + way * n[0], {}};
  for (const RationalFunction& x : r) refuse_poles(x.denominator(), "the curve is at infinity");
  const QuaternionPolynomial preimage{b, {}, {}, a};
  // r′ = (p + (way)′/|n′|)·n′ is f·(b + ia)², f = (p·2δ/D + way′)/D.
  const RationalFunction speed =
      p * RationalFunction(Rational(2) * turn, size) + differentiate(way);
  if (speed.is_zero()) throw DomainError("tangents: all lines go through one point");
  return over_one_weight(preimage, speed * RationalFunction({1}, size), r);
}

Vector<Polynomial> line_coordinates(const TangentLines& lines) {
  const auto& [a, b, p] = lines;
  return {-((a * a + b * b) * p.numerator()), Rational(2) * a * b * p.denominator(),
          (a * a - b * b) * p.denominator()};
}

// With w = u + iq = b + ia the tangent is w², and to the right of it is −i·w²/|w|² = n.
TangentLines tangent_lines(const Curve& curve) {
  const auto form = complex_form(curve);
  if (!form) throw DomainError("tangents: the curve is in no plane z = const");
  const auto& [u, q] = form->root;
  const Polynomial common = gcd(u, q);
  const Polynomial b = exact_quotient(u, common);
  const Polynomial a = exact_quotient(q, common);
  const Vector<Polynomial> X = numerator(curve);
  return {a, b,
          RationalFunction(Rational(2) * a * b * X[0] + (a * a - b * b) * X[1],
                           (a * a + b * b) * curve.weight())};
}

}  // namespace phrame
