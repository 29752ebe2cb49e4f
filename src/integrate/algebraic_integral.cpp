#include "phrame/integrate/algebraic_integral.hpp"

#include <algorithm>

#include "phrame/algebra/linear_system.hpp"

// (A/E·√S)′ = ((A′E − AE′)S + AES′/2)/(E²√S) is N/(D√S) where
//   D·((A′E − AE′)S + AES′/2) = N·E².
// At a zero of D of order m the integral has one of order m − 1 less, and at one that is a zero of
// S, where N/(D√S) has the order −m − 1/2 and the integral −m + 1/2, A/E has the order −m: so
// E = D·gcd(R, S)/R with the product R of the different factors of D. Towards infinity A/E·√S grows
// as t·N/(D√S), or tends to a constant, which its derivative does not show: so the degree of A is
// known. Another algebraic antiderivative would be its conjugate with −√S, up to a constant.
// Without D, a squarefree S that divides N, as it does for lengths, divides A·S′, so A.

namespace phrame::inline v0 {
namespace {

constexpr long most_unknowns = 40;

long degree_bound(const RootQuotient& f, const Polynomial& E) {
  const long n = f.numerator.degree();
  const long d = f.denominator.degree();
  const long s = f.radicand.degree();
  const long as_constant = s % 2 == 0 ? E.degree() - s / 2 : -1;
  return std::max(n - d - s + 1 + E.degree(), as_constant);
}

}  // namespace

Surd AlgebraicIntegral::operator()(const Rational& t) const {
  const Rational inside = radicand(t);
  const Rational c =
      factor.numerator()(t) / (factor.denominator()(t) * Rational(denominator(inside)));
  return {0, c, numerator(inside) * denominator(inside)};
}

std::optional<AlgebraicIntegral> algebraic_integral(const RootQuotient& f) {
  const auto& [N, D, S] = f;
  if (N.is_zero()) return AlgebraicIntegral{RationalFunction(), Polynomial{1}};
  if (D.is_constant() && S.is_constant())
    return AlgebraicIntegral{RationalFunction(antiderivative(N), D * S), S};
  const Polynomial R = D.is_constant() ? Polynomial{1} : squarefree_part(D);
  const Polynomial E = D.is_constant() ? Polynomial{1} : exact_quotient(D * gcd(R, S), R);
  const long most = degree_bound(f, E);
  if (most < 0 || most >= most_unknowns || N.degree() > 2 * most_unknowns) return std::nullopt;
  if (D.is_constant() && most < S.degree() && is_squarefree(S) && (N % S).is_zero())
    return std::nullopt;
  const Polynomial slope = Rational(1, 2) * differentiate(S) * E - differentiate(E) * S;
  std::vector<Polynomial> columns;
  for (long k = 0; k <= most; ++k) {
    const Polynomial power = pow(Polynomial{0, 1}, k);
    columns.push_back(D * (differentiate(power) * E * S + power * slope));
  }
  columns.push_back(N * E * E);
  for (const std::vector<Rational>& relation : linear_relations(columns)) {
    if (relation.back() == 0) continue;
    std::vector<Rational> a;
    for (long k = 0; k <= most; ++k) a.push_back(-relation[static_cast<std::size_t>(k)]);
    return AlgebraicIntegral{RationalFunction(Polynomial(a), E), S};
  }
  return std::nullopt;
}

}  // namespace phrame
