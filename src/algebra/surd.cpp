#include "phrame/algebra/surd.hpp"

#include <algorithm>

#include "phrame/algebra/error.hpp"

namespace phrame::inline v0 {

// With g = gcd(d, e) it is g·√((d/g)·(e/g)).
RootProduct multiply_roots(const Integer& d, const Integer& e) {
  if (d < 1 || e < 1) throw DomainError("surd: a root of a number that is not positive");
  const Integer g = gcd(d, e);
  const Integer rest = (d / g) * (e / g);
  const Integer root = sqrt(rest);
  if (root * root == rest) return {g * root, 1};
  return {g, rest};
}

bool RootField::contains(const Integer& d) const {
  return std::any_of(radicands_.begin(), radicands_.end(),
                     [&](const Integer& e) { return multiply_roots(d, e).radicand == 1; });
}

void RootField::adjoin(const Integer& d) {
  if (contains(d)) return;
  const std::size_t degree = radicands_.size();
  for (std::size_t k = 0; k < degree; ++k)
    radicands_.push_back(multiply_roots(radicands_[k], d).radicand);
}

std::vector<RootField> fields_without_a_root(const RootField& field) {
  const std::vector<Integer>& radicands = field.radicands();
  std::vector<RootField> fields;
  for (std::size_t left_out = 1; left_out < radicands.size(); left_out *= 2) {
    RootField others;
    for (std::size_t k = 1; k < radicands.size(); k *= 2)
      if (k != left_out) others.adjoin(radicands[k]);
    fields.push_back(std::move(others));
  }
  return fields;
}

Surd operator/(const Surd& x, const Surd& y) {
  if (y.is_zero()) throw DomainError("surd: division by zero");
  if (y.is_rational()) return (1 / y.rational_part()) * x;
  const Surd other = conjugate(y, half_field(y));
  return (x * other) / (y * other);
}

// x = u + v, where v is what changes its sign under an automorphism: where the signs of u and v
// differ, the greater square has it, and u² − v² is in a smaller field. So is v·√d for any term of
// v.
int sign(const Surd& x) {
  if (x.is_rational()) return x.rational_part().sign();
  const RootField half = half_field(x);
  const Surd other = conjugate(x, half);
  const int u = sign(x + other);
  const int v = sign(Surd(0, 1, x.terms().rbegin()->first) * (x - other));
  if (u == v || u == 0) return v;
  return sign(x * other) > 0 ? u : v;
}

SurdPolynomial surd_polynomial(const std::vector<Surd>& ascending) {
  SurdPolynomial p;
  for (std::size_t k = 0; k < ascending.size(); ++k)
    for (const auto& [d, c] : ascending[k].terms())
      p.add(Polynomial::monomial(c, static_cast<long>(k)), d);
  return p;
}

SurdPolynomial differentiate(const SurdPolynomial& p) {
  SurdPolynomial result;
  for (const auto& [d, c] : p.terms()) result.add(differentiate(c), d);
  return result;
}

long degree(const SurdPolynomial& p) {
  long degree = -1;
  for (const auto& [d, c] : p.terms()) degree = std::max(degree, c.degree());
  return degree;
}

Surd coefficient(const SurdPolynomial& p, long k) {
  Surd result;
  for (const auto& [d, c] : p.terms()) result.add(c.coefficient(k), d);
  return result;
}

Surd evaluate(const Polynomial& p, const Surd& x) {
  Surd value;
  for (long k = p.degree(); k >= 0; --k) value = value * x + Surd(p.coefficient(k));
  return value;
}

SquareFactor split_square(const Integer& x) {
  if (x < 1) throw DomainError("split_square: the number is not positive");
  constexpr unsigned largest_divisor = 10'000;
  Integer rest = x;
  SquareFactor result{1, 1};
  for (unsigned p = 2; p <= largest_divisor && Integer(p) * p <= rest; ++p) {
    for (; rest % (p * p) == 0; rest /= p * p) result.root *= p;
    if (rest % p != 0) continue;
    result.rest *= p;
    rest /= p;
  }
  const Integer root = sqrt(rest);
  if (root * root == rest)
    result.root *= root;
  else
    result.rest *= rest;
  return result;
}

// √(n/m) = √(nm)/m.
QuadraticNumber quadratic_root(const Polynomial& p) {
  if (p.degree() < 1 || p.degree() > 2)
    throw DomainError("quadratic_root: the degree is not 1 or 2");
  const Rational lead = p.leading_coefficient();
  if (p.degree() == 1) return {-p.coefficient(0) / lead, 0, 1};
  const Rational a = -p.coefficient(1) / (2 * lead);
  const Rational square = a * a - p.coefficient(0) / lead;
  const auto [root, rest] = split_square(abs(Integer(numerator(square) * denominator(square))));
  const Rational b = Rational(root) / Rational(denominator(square));
  const Integer d = square < 0 ? Integer(-rest) : rest;
  if (d == 1) throw DomainError("quadratic_root: the polynomial is reducible");
  return {a, b, d};
}

}  // namespace phrame
