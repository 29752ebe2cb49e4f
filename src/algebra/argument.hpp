#pragma once
#include <optional>

#include "phrame/algebra/ball.hpp"
#include "phrame/algebra/sturm.hpp"

namespace phrame {

/// The continuous argument of γ(t) ∈ ℂ along the real line, counted from t = 0. No root is found:
/// the difference of principal arguments is exact up to whole turns, and these are counted by the
/// Cauchy index of Im/Re, exactly. Not for concurrent use.
class ContinuousArgument {
 public:
  /// Throws DomainError where γ has a real zero (or is 0): its argument jumps there.
  explicit ContinuousArgument(const GaussianPolynomial& gamma);

  /// arg γ(t) − arg γ(0) = arctan(y/x) + π·half_turns for x + iy = γ(t)/γ(0) up to a positive
  /// factor and, where that is purely imaginary, a fixed rotation.
  RealBall difference(const Rational& t, long bits);

 private:
  /// The parts of γ times a constant; x(0) > 0.
  struct Coordinates {
    Polynomial x;
    Polynomial y;
    std::optional<SturmChain> chain;  ///< of (x, y), made when it is first needed

    /// −(the Cauchy index of y/x between 0 and t), the half turns made. Precondition: x(t) ≠ 0.
    long half_turns(const Rational& t);
  };

  Coordinates straight_;  ///< γ·conj γ(0): starts on the positive real axis
};

}  // namespace phrame
