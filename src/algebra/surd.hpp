#pragma once
#include "phrame/algebra/polynomial.hpp"

namespace phrame {

/// a + b·√d, d > 1 an integer that is no square; b = 0 and d = 1 for a rational number.
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

/// x = root²·rest for an integer x ≥ 1; rest is 1 where x is a square, and has no square factor p²
/// with p ≤ 10⁴. (To find all square factors is as hard as to factor x.)
struct SquareFactor {
  Integer root;
  Integer rest;
};
SquareFactor split_square(const Integer& x);

}  // namespace phrame
