#pragma once
// Linear systems of the papers, solved as they stand: a second way to what phrame finds in closed
// form.
#include <optional>
#include <vector>

#include "phrame/algebra/linear_system.hpp"
#include "phrame/integrate/hermite.hpp"
#include "phrame/ph/curve/invariants.hpp"

namespace phrame::inline v0::test {

/// The only x with Σ x_k·columns[k] = right side; no value where there is none or another one, too.
inline std::optional<std::vector<Rational>> solved(std::vector<Polynomial> columns,
                                                   const Polynomial& right_side) {
  columns.push_back(-right_side);
  auto relations = linear_relations(columns);
  if (relations.size() != 1 || relations.front().back() == 0) return std::nullopt;
  relations.front().pop_back();
  return std::move(relations.front());
}

/// The unknowns as two polynomials, of which the first has that degree at most, less one.
inline std::pair<Polynomial, Polynomial> parted(const std::vector<Rational>& x, long first) {
  const auto middle = x.begin() + first;
  return {Polynomial(std::vector(x.begin(), middle)), Polynomial(std::vector(middle, x.end()))};
}

/// f = (p₁/q₁)′ + p₂/q₂ as hermite_reduce() has it, by the system of Horowitz and Ostrogradsky
/// [Farouki 2003, §3, (19)–(22)]: p = q₂p₁′ − s·p₁ + q₁p₂.
inline RationalPart horowitz_reduce(const RationalFunction& f) {
  const Polynomial& q = f.denominator();
  const Polynomial q1 = gcd(q, differentiate(q));
  const Polynomial q2 = exact_quotient(q, q1);
  const Polynomial s = exact_quotient(differentiate(q1) * q2, q1);
  std::vector<Polynomial> columns;
  for (long k = 0; k < q1.degree(); ++k) {
    const Polynomial power = Polynomial::monomial(1, k);
    columns.push_back(q2 * differentiate(power) - s * power);
  }
  for (long k = 0; k < q2.degree(); ++k) columns.push_back(q1 * Polynomial::monomial(1, k));
  const auto [p1, p2] = parted(solved(columns, f.numerator()).value(), q1.degree());
  return {{p1, q1}, {p2, q2}};
}

/// closed_split() by the system (15) of [Farouki 2003], deg a < deg σ and deg b < deg ρ. No value
/// where that has no solution or several, as where gcd(σ, ρ) ≠ 1.
inline std::optional<AngleSplit> split_by_linear_system(const QuaternionPolynomial& preimage) {
  const Polynomial s = sigma(preimage);
  const Polynomial r = rho(preimage);
  std::vector<Polynomial> columns;
  for (long k = 0; k < s.degree(); ++k) columns.push_back(r * Polynomial::monomial(1, k));
  for (long k = 0; k < r.degree(); ++k) columns.push_back(s * Polynomial::monomial(1, k));
  const auto x = solved(columns, triple_product(Curve(preimage)));
  if (!x) return std::nullopt;
  const auto [a, b] = parted(*x, s.degree());
  return AngleSplit{a, b};
}

}  // namespace phrame::test
