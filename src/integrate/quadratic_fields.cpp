// An irreducible quartic is, with t = y + s, a multiple of
//   y⁴ + Py² + Qy + R = (y² + Ey + F)(y² − Ey + G),
//   F + G − E² = P,  E(G − F) = Q,  FG = R,
// and w = E² is a root of w³ + 2Pw² + (P² − 4R)w − Q² (Descartes). Over a real quadratic field its
// two factors are conjugate, for their product is rational and they are not. So either E = e√D,
// and w = e²D > 0 is rational, or E = 0, Q = 0 and F, G = (P ± √(P² − 4R))/2 are real. Conversely,
// every rational w > 0 gives a factorization, with F = (P + w)/2 − Q/(2E).
//
// With the factor f = A + B√D, the fraction n/(f·f̄) is (X + Y√D)/f and its conjugate, where
//   n = (X + Y√D)·f̄ + (X − Y√D)·f = 2(A·X − D·B·Y),  deg X, deg Y ≤ 1:
// four linear equations, which have one solution, as f and f̄ are coprime.
#include "phrame/integrate/quadratic_fields.hpp"

#include <algorithm>

#include "phrame/algebra/error.hpp"
#include "phrame/algebra/factor.hpp"
#include "phrame/algebra/linear_system.hpp"
#include "phrame/algebra/surd_root.hpp"

namespace phrame {
namespace {

/// (t − s)² + E(t − s) + F.
SurdPolynomial shifted_factor(const Surd& E, const Surd& F, const Rational& s) {
  const Surd shift{s, 0};
  const Surd linear = E - Surd{2 * s, 0};
  const Surd constant = shift * shift - shift * E + F;
  const Integer d = linear.d == 1 ? constant.d : linear.d;
  return {{constant.a, linear.a, 1}, {constant.b, linear.b}, d};
}

std::vector<SurdPolynomial> real_quadratic_factors(const Polynomial& quartic) {
  const Rational lead = quartic.leading_coefficient();
  const Rational s = -quartic.coefficient(3) / (4 * lead);
  const Polynomial f = (1 / lead) * compose(quartic, {s, 1});
  const Rational P = f.coefficient(2);
  const Rational Q = f.coefficient(1);
  const Rational R = f.coefficient(0);
  std::vector<SurdPolynomial> found;
  for (const auto& [base, exponent] : factor({-Q * Q, P * P - 4 * R, 2 * P, 1}).factors) {
    if (base.degree() != 1) continue;
    const Rational w = -base.coefficient(0) / base.coefficient(1);
    if (w <= 0) continue;
    const Surd E = quadratic_root({-w, 0, 1});
    found.push_back(shifted_factor(E, {(P + w) / 2, -Q * E.b / (2 * w), E.d}, s));
  }
  if (Q == 0 && P * P > 4 * R)
    found.push_back(shifted_factor({0, 0}, quadratic_root({R, -P, 1}), s));
  return found;
}

/// The square of half the difference of its zeros.
Surd quarter_discriminant(const SurdPolynomial& factor) {
  const Surd half = Surd{Rational(1, 2), 0} * coefficient(factor, 1);
  return half * half - coefficient(factor, 0);
}

/// How hard its zeros are to write: √ of a rational number, a sum of such, a root of a root.
int complexity(const SurdPolynomial& factor) {
  const Surd h = quarter_discriminant(factor);
  return h.b == 0 ? 0 : has_simple_root(h) ? 1 : 2;
}

}  // namespace

std::optional<ConjugateFractions> over_real_quadratic_field(const SimpleFraction& f) {
  if (f.denominator.degree() != 4)
    throw DomainError("over_real_quadratic_field: the denominator is not of degree 4");
  const std::vector<SurdPolynomial> factors = real_quadratic_factors(f.denominator);
  const auto simplest =
      std::min_element(factors.begin(), factors.end(),
                       [](const auto& g, const auto& h) { return complexity(g) < complexity(h); });
  if (simplest == factors.end()) return std::nullopt;
  const Polynomial A = Rational(2) * simplest->a;
  const Polynomial B = Rational(-2) * Rational(simplest->d) * simplest->b;
  const Polynomial t{0, 1};
  const auto x = solve_for_coefficients({A, t * A, B, t * B},
                                        (1 / f.denominator.leading_coefficient()) * f.numerator, 4);
  if (!x) throw Error("over_real_quadratic_field: conjugate factors are not coprime");
  return ConjugateFractions{{{(*x)[0], (*x)[1]}, {(*x)[2], (*x)[3]}, simplest->d}, *simplest};
}

}  // namespace phrame
