#pragma once
#include "phrame/integrate/evaluator.hpp"

namespace phrame::inline v0 {

/// G(s) = ∫₀ˢ du/V(u), the time that a motion takes with a speed V > 0 that depends on the way.
class TimeOfLength {
 public:
  explicit TimeOfLength(const RationalFunction& speed);  ///< V

  /// Of 1/V, so that differences of it are times.
  const Antiderivative& antiderivative() const { return antiderivative_; }
  /// G(s), exact where it is seen to be rational.
  Real value(const Real& s) const;
  /// Of all s ≥ 0 of a ball.
  RealBall enclose(const RealBall& s, long bits) const;
  /// 1/V on the ball.
  RealBall rate(const RealBall& s, long bits) const;

 private:
  RationalFunction speed_;
  Antiderivative antiderivative_;
  Evaluator evaluator_;
};

}  // namespace phrame
