#pragma once
#include "phrame/algebra/polynomial.hpp"

namespace phrame {

/// a + b·√d, d an integer that is no square, with √d = i·√|d| for d < 0; b = 0 and d = 1 for a
/// rational number.
struct Surd {
  Rational a;
  Rational b;
  Integer d = 1;
  friend bool operator==(const Surd&, const Surd&) = default;
};

/// a(t) + b(t)·√d, d likewise; b = 0 and d = 1 for a rational polynomial.
struct SurdPolynomial {
  Polynomial a;
  Polynomial b;
  Integer d = 1;
  friend bool operator==(const SurdPolynomial&, const SurdPolynomial&) = default;
};

/// a + b·√d for a d that is 1 or no square.
Surd surd(const Rational& a, const Rational& b, const Integer& d);
SurdPolynomial surd_polynomial(const Polynomial& a, const Polynomial& b, const Integer& d);

// Arithmetic in one field ℚ(√d): the operands have the same d, or one of them is rational.

Surd operator+(const Surd& x, const Surd& y);
Surd operator-(const Surd& x);
Surd operator-(const Surd& x, const Surd& y);
Surd operator*(const Surd& x, const Surd& y);
/// Throws DomainError for y = 0.
Surd operator/(const Surd& x, const Surd& y);
/// a − b√d.
Surd conjugate(const Surd& x);
/// a² − d·b² = x·conjugate(x).
Rational norm(const Surd& x);
/// −1, 0 or 1, of a real x: d > 0.
int sign(const Surd& x);

SurdPolynomial operator+(const SurdPolynomial& p, const SurdPolynomial& q);
SurdPolynomial operator-(const SurdPolynomial& p, const SurdPolynomial& q);
SurdPolynomial operator*(const SurdPolynomial& p, const SurdPolynomial& q);
SurdPolynomial operator*(const Surd& x, const SurdPolynomial& p);
SurdPolynomial conjugate(const SurdPolynomial& p);
SurdPolynomial differentiate(const SurdPolynomial& p);
/// a² − d·b².
Polynomial norm(const SurdPolynomial& p);
/// The coefficient of tᵏ.
Surd coefficient(const SurdPolynomial& p, long k);

/// A root of p of degree 1 or 2, the one with b ≥ 0; p irreducible over ℚ. Throws DomainError for
/// other degrees.
Surd quadratic_root(const Polynomial& p);

/// x = root²·rest for an integer x ≥ 1; rest is 1 where x is a square, and has no square factor p²
/// with p ≤ 10⁴. (To find all square factors is as hard as to factor x.)
struct SquareFactor {
  Integer root;
  Integer rest;
};
SquareFactor split_square(const Integer& x);

}  // namespace phrame
