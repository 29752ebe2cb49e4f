#pragma once
#include <optional>

#include "phrame/algebra/ball.hpp"
#include "phrame/algebra/sturm.hpp"

namespace phrame {

/// The continuous argument of γ(t) ∈ ℂ along the real line, counted from t = 0. No root is found:
/// the difference of principal arguments is exact up to whole turns, and these are counted by the
/// Cauchy index of Im/Re, exactly.
class ContinuousArgument {
 public:
  /// Throws DomainError where γ has a real zero (or is 0): its argument jumps there.
  explicit ContinuousArgument(const GaussianPolynomial& gamma);

  /// arg γ(t) − arg γ(0) = arctan(y/x) + π·half_turns for x + iy = γ(t)/γ(0) up to a positive
  /// factor and, where that is purely imaginary, a fixed rotation.
  RealBall difference(const Rational& t, long bits) const;

  /// Is arg γ(t) = arg γ(0) exactly?
  bool is_zero_at(const Rational& t) const;

 private:
  /// The parts of γ times a constant, with the chain that counts the jumps of y/x.
  struct Coordinates {
    Polynomial x;
    Polynomial y;
    SturmChain chain;
    explicit Coordinates(const GaussianPolynomial& rotated)
        : x(rotated.re), y(rotated.im), chain(rotated.re, rotated.im) {}
    /// −(the Cauchy index of y/x between 0 and t): the half turns made, x(0) > 0 and x(t) ≠ 0.
    long half_turns(const Rational& t) const;
  };

  Coordinates straight_;  ///< γ·conj γ(0): starts on the positive real axis
};

}  // namespace phrame
