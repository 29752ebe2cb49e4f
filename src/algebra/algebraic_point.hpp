#pragma once
#include "phrame/algebra/rational_function.hpp"
#include "phrame/algebra/real_algebraic.hpp"
#include "phrame/algebra/shared.hpp"

namespace phrame::inline v0 {

/// A real algebraic number t at which many functions are evaluated: its enclosures are shared. A
/// value is exact where it is rational, which is decided by algebra; else it is irrational, so that
/// its correct rounding ends.
class AlgebraicPoint {
 public:
  /// The point with the parameter t.
  explicit AlgebraicPoint(RealAlgebraic t);

  const RealAlgebraic& number() const { return t_; }  ///< t
  RealBall enclose(long bits) const;  ///< a ball around t with a radius ≤ 2^−bits · max(1, |t|)

  Real value(const Polynomial& p) const;  ///< p(t)
  /// f(t). Throws DomainError at a pole.
  Real value(const RationalFunction& f) const;
  /// √f(t) ≥ 0. Throws DomainError at a pole and where f(t) < 0.
  Real square_root(const RationalFunction& f) const;
  /// n(t)/(d(t)·√s(t)), where d(t) > 0 and s(t) > 0.
  Real over_square_root(const Polynomial& n, const Polynomial& d, const Polynomial& s) const;

 private:
  RealAlgebraic t_;
  Refined<RealBall> enclosure_;
};

}  // namespace phrame
