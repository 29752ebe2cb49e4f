#pragma once
#include <utility>
#include <vector>

#include "phrame/algebra/ball.hpp"

namespace phrame::inline v0 {

/// A polynomial in one variable with real balls for coefficients: all the polynomials whose
/// coefficients lie in them.
class BallPolynomial {
 public:
  BallPolynomial() = default;  ///< exactly 0
  /// p, with its coefficients in balls of so many bits.
  BallPolynomial(const Polynomial& p, long bits);
  /// The coefficients of t⁰, t¹, …
  explicit BallPolynomial(const std::vector<RealBall>& ascending);

  /// No polynomial of the set has a higher degree; −1 for 0.
  long degree_bound() const { return arb_poly_length(raw()) - 1; }
  RealBall coefficient(long k) const;  ///< 0 beyond the degree; k ≥ 0

  arb_poly_struct* raw() { return handle_.get(); }
  const arb_poly_struct* raw() const { return handle_.get(); }

 private:
  flint::ArbPoly handle_;
};

/// p but for the coefficient of t⁰, which is c.
BallPolynomial with_constant(BallPolynomial p, const RealBall& c);
BallPolynomial operator-(BallPolynomial p);  ///< exactly
/// @{ The sum, difference and product.
BallPolynomial add(const BallPolynomial& p, const BallPolynomial& q, long bits);
BallPolynomial subtract(const BallPolynomial& p, const BallPolynomial& q, long bits);
BallPolynomial multiply(const BallPolynomial& p, const BallPolynomial& q, long bits);
BallPolynomial multiply(const RealBall& c, const BallPolynomial& p, long bits);
/// @}
BallPolynomial differentiate(const BallPolynomial& p, long bits);  ///< p′
/// ∫₀ᵗ p.
BallPolynomial antiderivative(BallPolynomial p, long bits);
/// p(t + by): the Taylor polynomial at `by`.
BallPolynomial shifted(BallPolynomial p, const RealBall& by, long bits);
/// p(2ᵉ·t), exactly.
BallPolynomial stretched(BallPolynomial p, long e);

/// p(x).
RealBall evaluate(const BallPolynomial& p, const RealBall& x, long bits);

/// The Bernstein coefficients on [0, 1] in degree n ≥ max(degree_bound(), 0): p lies between the
/// least and the greatest there.
std::vector<RealBall> to_bernstein(const BallPolynomial& p, long n, long bits);
/// The Bernstein coefficients on [0, share] and [share, 1], by de Casteljau's algorithm.
std::pair<std::vector<RealBall>, std::vector<RealBall>> split(
    const std::vector<RealBall>& coefficients, const Rational& share, long bits);
/// The polynomial with these Bernstein coefficients, at least one.
BallPolynomial from_bernstein(std::vector<RealBall> coefficients, long bits);

/// Where a polynomial changes its sign.
struct SignChanges {
  std::vector<RealBall> at;  ///< one zero of odd order in each, ascending, radius ≤ 2^−bits
  std::vector<RealBall> undecided;  ///< there may be others in these only
  /// Are these all?
  bool is_complete() const { return undecided.empty(); }
};
/// On (0, 1), by Bernstein coefficients on smaller and smaller parts. What is closer than about
/// 2^−bits to an end, to another zero, or to being one, is not decided.
SignChanges sign_changes(const BallPolynomial& p, long bits);

}  // namespace phrame
