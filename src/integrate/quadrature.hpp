#pragma once
#include <functional>
#include <map>
#include <vector>

#include "phrame/algebra/ball_polynomial.hpp"
#include "phrame/algebra/rational_function.hpp"

namespace phrame {

inline constexpr long most_points_by_default = 100'000;

/// A ball around ∫ₐᵇ f by Arb's certified numerical quadrature, with a radius of about 2^−bits; a
/// wide or infinite one where that fails, as at a pole on [a, b], or with so many values of f. The
/// precision rises with what f loses next to poles. It knows no antiderivative and no root: the
/// other way to a value [Johansson 2018].
RealBall quadrature(const RationalFunction& f, const Rational& a, const Rational& b, long bits,
                    long most_points = most_points_by_default);

/// Encloses f(z): for a ball z around which f is not analytic, an infinite ball.
using AnalyticFunction = std::function<ComplexBall(const ComplexBall& z, long bits)>;

/// A ball around ∫₀¹ f, in the same manner, with `bits` + 64 + `more` bits of precision for f, of
/// whatever width is reached with so many values of f.
RealBall quadrature(const AnalyticFunction& f, long bits, long more,
                    long most_points = most_points_by_default);

/// p(z), on a large ball not much wider than necessary.
ComplexBall evaluate(const BallPolynomial& p, const ComplexBall& z, long bits);

/// A polynomial in an integrand. A quadrature asks for its values on many discs around few real
/// numbers, and other quadratures for the same again: its Taylor polynomials there, which cost most
/// of it, are kept. Not for concurrent use.
class IntegrandPolynomial {
 public:
  IntegrandPolynomial() = default;
  IntegrandPolynomial(BallPolynomial p) : p_(std::move(p)) {}  // NOLINT: it is one

  /// As evaluate().
  ComplexBall operator()(const ComplexBall& z, long bits) const;

 private:
  struct Taylor {
    long bits = 0;
    RealBall value;
    std::vector<flint::Mag> sizes;  ///< of the coefficients
  };
  BallPolynomial p_;
  mutable std::map<double, Taylor> at_;
};

}  // namespace phrame
