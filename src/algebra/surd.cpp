#include "phrame/algebra/surd.hpp"

#include "phrame/algebra/error.hpp"

namespace phrame {

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
Surd quadratic_root(const Polynomial& p) {
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
