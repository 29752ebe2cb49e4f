// Let f₀ = gcd(x′, y′, z′) and (x, y, z) = r′/f₀, with all numbers taken out, so that the three
// have coprime integer coefficients and no common root, and let N = x² + y² + z².
//
// If r′ = f·A i A* then |r′|² = (f|A|²)² is a square in ℚ[t], hence N is one. Conversely let N =
// s²; s has no real zero and is taken > 0. Over ℚ(i)[t], a principal ideal domain, the Hermitian
// matrix
//   M = [[X, Z], [Z̄, Y]],  X = (s + x)/2,  Y = (s − x)/2,  Z = (y + iz)/2,
// has the determinant 0, so M = λ·w w* with a primitive vector w = (α, β) and λ real. The entries
// of w w* have no common divisor, and those of M have none: it would divide s = X + Y, x, y and z.
// So λ is a constant, and positive, as X, Y ≥ 0. Now |α|² − |β|², 2αβ̄ are (x, y + iz)/λ: this is
// the Hopf form of A, x = λ·(A i A*)₁ and so on. A rational preimage thus exists whenever N is a
// square.
//
// α and β being coprime, gcd(X, Z) = λα·gcd(ᾱ, β̄) = α up to a unit, and then X = λ|α|², Z = λαβ̄.
// The degree of α is half that of X. Where X = 0, y and z are 0 and w = (0, 1).
//
// Uniqueness: w is unique up to ℚ(i)*, and c ∈ ℚ(i)* changes λ by |c|². So λ is unique up to norms:
// λ = n/d = nd/d² = rest·|root/d|² with nd = rest·|root|², and root/d goes into A. Where w is
// primitive over ℤ[i], λ is 1 for a curve that was made from a primitive preimage with integer
// coefficients.
#include "phrame/ph/curve/identify.hpp"

#include <fmt/format.h>

#include <ostream>

#include "phrame/algebra/error.hpp"
#include "phrame/algebra/factor.hpp"
#include "phrame/algebra/gaussian_integer.hpp"
#include "phrame/algebra/modular.hpp"
#include "phrame/algebra/surd.hpp"
#include "phrame/ph/curve/vector.hpp"

namespace phrame::inline v0 {
namespace {

/// The coefficient of tᵏ, where the coefficients are integers.
GaussianInteger coefficient(const GaussianPolynomial& a, long k) {
  return {Integer(numerator(a.re.coefficient(k))), Integer(numerator(a.im.coefficient(k)))};
}

/// r·c·w.
HopfForm multiple(const Rational& r, const GaussianInteger& c, const HopfForm& w) {
  const GaussianPolynomial factor{{r * Rational(c.re)}, {r * Rational(c.im)}};
  return {factor * w.alpha, factor * w.beta};
}

/// w over all that its coefficients have in common in ℤ[i]: first in ℤ, then the divisor g, which
/// also divides the norms.
HopfForm primitive(const HopfForm& w) {
  const Rational real = common_content({w.alpha.re, w.alpha.im, w.beta.re, w.beta.im});
  const HopfForm result = multiple(1 / real, {1, 0}, w);
  Integer norms = 0;
  for (const auto* part : {&result.alpha, &result.beta})
    for (long k = 0; k <= degree(*part) && norms != 1; ++k)
      norms = gcd(norms, norm(coefficient(*part, k)));
  GaussianInteger g{norms, 0};
  for (const auto* part : {&result.alpha, &result.beta})
    for (long k = 0; k <= degree(*part) && norm(g) != 1; ++k) g = gcd(g, coefficient(*part, k));
  return multiple(Rational(1, norm(g)), conjugate(g), result);
}

/// w·iᵏ with its lowest coefficient, of α unless that is 0, in the first quadrant.
HopfForm in_first_quadrant(const HopfForm& w) {
  const GaussianPolynomial& part = is_zero(w.alpha) ? w.beta : w.alpha;
  long k = 0;
  while (norm(coefficient(part, k)) == 0) ++k;
  const GaussianInteger lowest = coefficient(part, k);
  return multiple(Rational(1, norm(lowest)), first_quadrant(lowest) * conjugate(lowest), w);
}

/// The primitive w with λ·w w* = M.
HopfForm primitive_root(const Vector<Polynomial>& c, const Polynomial& speed) {
  const Polynomial x = Rational(1, 2) * (speed + c[0]);
  const GaussianPolynomial z{Rational(1, 2) * c[1], Rational(1, 2) * c[2]};
  if (x.is_zero()) return {{}, {{1}, {}}};
  const GaussianPolynomial alpha = gcd({x, {}}, z);
  const Polynomial inverse{1 / x.leading_coefficient()};
  return primitive({alpha, inverse * conjugate(exact_quotient(z, alpha))});
}

/// N, which is no square, up to a square. Its leading coefficient is positive.
NotPythagorean reason(const Polynomial& n) {
  const auto [unit, factors] = squarefree_factorization(n);
  NotPythagorean result{{1}, split_square(Integer(numerator(unit))).rest};
  for (const auto& [base, exponent] : factors)
    if (exponent % 2 == 1) result.odd_factor *= base;
  return result;
}

}  // namespace

std::string to_string(const NotPythagorean& reason) {
  if (reason.odd_factor == Polynomial{1})
    return fmt::format(
        "|r'| is sqrt({}) times a polynomial: the curve is PH over the reals, but has no preimage "
        "with rational coefficients, whatever the multiplier",
        abbreviated(reason.radicand.str()));
  return fmt::format("|r'| is no polynomial: |r'|^2 has the factor {} to an odd power",
                     abbreviated(to_string(reason.odd_factor), 120));
}

bool is_pythagorean(const Vector<Polynomial>& direction) {
  const auto& [x, y, z] = direction;
  return !sum_of_squares_is_seen_no_square(x, y, z) &&
         square_root(dot(direction, direction)).has_value();
}

std::variant<Curve, NotPythagorean> identify(const Vector<Polynomial>& hodograph,
                                             const Vector<Rational>& start) {
  const auto& [dx, dy, dz] = hodograph;
  const Rational number = common_content({dx, dy, dz});
  if (number == 0) throw DomainError("identify: the hodograph is zero, so the curve is a point");
  Polynomial f = gcd(hodograph);
  long order = 0;
  while (f.coefficient(order) == 0) ++order;
  if (f.coefficient(order) < 0) f = -std::move(f);
  Vector<Polynomial> c;
  for (std::size_t k = 0; k < 3; ++k) c[k] = Rational(1 / number) * exact_quotient(hodograph[k], f);
  const Polynomial n = dot(c, c);
  const auto speed = square_root(n);
  if (!speed) return reason(n);

  const HopfForm w = primitive_root(c, *speed);
  const Rational lambda = number * speed->leading_coefficient() /
                          Polynomial(norm(w.alpha) + norm(w.beta)).leading_coefficient();
  const auto [root, rest] = split_norm(Integer(numerator(lambda) * denominator(lambda)));
  const HopfForm form =
      multiple(Rational(1, denominator(lambda)), {1, 0}, in_first_quadrant(multiple(1, root, w)));
  Curve result(from_hopf_form(form), Rational(rest) * f, start);
  if (hodograph_numerator(result) != hodograph)
    throw Error("identify: the check failed, f · A i A* is not the hodograph");
  return result;
}

std::variant<Curve, NotPythagorean> identify(const Vector<Polynomial>& hodograph) {
  return identify(hodograph, {});
}

std::variant<Curve, NotPythagorean> identify(const RationalCurve& curve) {
  auto found = identify(hodograph(curve), point(curve, 0));
  if (const auto* ph = std::get_if<Curve>(&found); ph != nullptr && !curve.weight().is_constant())
    found = Curve::quotient(ph->preimage(), ph->multiplier(), curve.numerator(), curve.weight());
  return found;
}

std::ostream& operator<<(std::ostream& out, const NotPythagorean& reason) {
  return out << to_string(reason);
}

}  // namespace phrame
