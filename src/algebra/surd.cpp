#include "phrame/algebra/surd.hpp"

#include "phrame/algebra/error.hpp"

namespace phrame {

Surd surd(const Rational& a, const Rational& b, const Integer& d) {
  return b == 0 || d == 1 ? Surd{a + b, 0, 1} : Surd{a, b, d};
}

SurdPolynomial surd_polynomial(const Polynomial& a, const Polynomial& b, const Integer& d) {
  return b.is_zero() || d == 1 ? SurdPolynomial{a + b, {}, 1} : SurdPolynomial{a, b, d};
}

namespace {

/// The d of a field that holds both.
template <class T>
Integer common_radicand(const T& x, const T& y) {
  if (x.d != 1 && y.d != 1 && x.d != y.d)
    throw DomainError("surd: √" + x.d.str() + " and √" + y.d.str() + " are of different fields");
  return x.d == 1 ? y.d : x.d;
}

}  // namespace

Surd operator+(const Surd& x, const Surd& y) {
  return surd(x.a + y.a, x.b + y.b, common_radicand(x, y));
}

Surd operator-(const Surd& x) { return {-x.a, -x.b, x.d}; }

Surd operator-(const Surd& x, const Surd& y) { return x + -y; }

Surd operator*(const Surd& x, const Surd& y) {
  const Integer d = common_radicand(x, y);
  return surd(x.a * y.a + Rational(d) * x.b * y.b, x.a * y.b + x.b * y.a, d);
}

Surd operator/(const Surd& x, const Surd& y) {
  const Rational n = norm(y);
  if (n == 0) throw DomainError("surd: division by zero");
  return x * surd(y.a / n, -y.b / n, y.d);
}

Surd conjugate(const Surd& x) { return {x.a, -x.b, x.d}; }

Rational norm(const Surd& x) { return x.a * x.a - Rational(x.d) * x.b * x.b; }

int sign(const Surd& x) {
  const auto of = [](const Rational& r) { return r > 0 ? 1 : r < 0 ? -1 : 0; };
  if (of(x.a) == of(x.b) || x.b == 0) return of(x.a);
  // a and b√d pull in different directions: the greater square has it.
  return norm(x) > 0 ? of(x.a) : of(x.b);
}

SurdPolynomial operator+(const SurdPolynomial& p, const SurdPolynomial& q) {
  return surd_polynomial(p.a + q.a, p.b + q.b, common_radicand(p, q));
}

SurdPolynomial operator-(const SurdPolynomial& p, const SurdPolynomial& q) {
  return surd_polynomial(p.a - q.a, p.b - q.b, common_radicand(p, q));
}

SurdPolynomial operator*(const SurdPolynomial& p, const SurdPolynomial& q) {
  const Integer d = common_radicand(p, q);
  return surd_polynomial(p.a * q.a + Rational(d) * (p.b * q.b), p.a * q.b + p.b * q.a, d);
}

SurdPolynomial operator*(const Surd& x, const SurdPolynomial& p) {
  return surd_polynomial({x.a}, {x.b}, x.d) * p;
}

SurdPolynomial conjugate(const SurdPolynomial& p) { return {p.a, -p.b, p.d}; }

SurdPolynomial differentiate(const SurdPolynomial& p) {
  return surd_polynomial(differentiate(p.a), differentiate(p.b), p.d);
}

Polynomial norm(const SurdPolynomial& p) { return p.a * p.a - Rational(p.d) * (p.b * p.b); }

Surd coefficient(const SurdPolynomial& p, long k) {
  return surd(p.a.coefficient(k), p.b.coefficient(k), p.d);
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
