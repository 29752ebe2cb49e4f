#pragma once
#include "phrame/ph/curve/curve.hpp"
#include "phrame/ph/curve/rational_curve.hpp"

namespace phrame::inline v0::test {

/// r(c·t/(1 + (c − 1)·t)), which goes from 0 to 1 as r does: the same curve, as a rational one.
inline RationalCurve reparametrized(const Curve& curve, const Rational& c) {
  const long n = degree(curve);
  const Polynomial above{0, c};
  const Polynomial below{1, c - 1};
  Vector<Polynomial> X;
  for (std::size_t k = 0; k < 3; ++k) {
    const Polynomial r = position(curve)[k];
    for (long j = 0; j <= n; ++j) X[k] += r.coefficient(j) * pow(above, j) * pow(below, n - j);
  }
  return RationalCurve(X, pow(below, n));
}

/// A quarter of the unit circle, ((1 − t²), 2t, 0)/(1 + t²).
inline Curve quarter_circle() {
  return Curve::quotient({{1, -1}, {}, {}, {1, 1}}, Polynomial{1},
                         {Polynomial{1, 0, -1}, Polynomial{0, 2}, Polynomial{}},
                         Polynomial{1, 0, 1});
}

/// The same with the weight cW.
inline Curve with_factor(const Curve& curve, const Polynomial& c) {
  Vector<Polynomial> X = numerator(curve);
  for (Polynomial& x : X) x *= c;
  return Curve::quotient(curve.preimage(), curve.multiplier() * c * c, X, curve.weight() * c);
}

}  // namespace phrame::test
