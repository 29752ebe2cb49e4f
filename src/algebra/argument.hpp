#pragma once
#include <string>

#include "phrame/algebra/ball.hpp"
#include "phrame/algebra/shared.hpp"
#include "phrame/algebra/sturm.hpp"

namespace phrame::inline v0 {

/// The continuous argument of γ(t) ∈ ℂ along the real line, counted from t = 0. No root is found:
/// the difference of principal arguments is exact up to whole turns, and these are counted by the
/// Cauchy index of Im/Re, exactly.
class ContinuousArgument {
 public:
  /// Throws DomainError where γ has a real zero (or is 0): its argument jumps there.
  explicit ContinuousArgument(const GaussianPolynomial& gamma);

  /// arg γ(t) − arg γ(0) = arctan(y/x)(t) − arctan(y/x)(0) − π·index for x + iy = coordinates(t).
  RealBall difference(const Rational& t, long bits) const;

  /// γ·conj γ(0), which starts on the positive real axis; 1 + i times that where it is on the
  /// imaginary axis at t.
  GaussianPolynomial coordinates(const Rational& t) const;
  /// The turns counted between 0 and t, and the signs from which they are.
  TurnCount turn(const Rational& t) const;

 private:
  const SturmChain& chain_at(const Rational& t) const;

  GaussianPolynomial straight_;
  Lazy<SturmChain> chain_;         ///< of straight_
  Lazy<SturmChain> turned_chain_;  ///< of straight_·(1 + i)
};

}  // namespace phrame
