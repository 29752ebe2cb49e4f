#pragma once
#include <map>
#include <vector>

#include "phrame/algebra/ball_polynomial.hpp"

namespace phrame::inline v0 {

/// Is z as small as points are at this precision? A disc next to a pole is not, however small:
/// there Horner's rule gives a ball that is much larger than the distance to the pole squared.
bool is_point(const ComplexBall& z, long precision);

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
