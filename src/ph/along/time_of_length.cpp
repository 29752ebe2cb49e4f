#include "phrame/ph/along/time_of_length.hpp"

#include <algorithm>

#include "phrame/integrate/integrate.hpp"

namespace phrame::inline v0 {

TimeOfLength::TimeOfLength(const RationalFunction& speed)
    : speed_(speed),
      antiderivative_(integrate(RationalFunction(speed.denominator(), speed.numerator()))),
      evaluator_(antiderivative_) {}

Real TimeOfLength::value(const Real& s) const {
  if (s.exact()) return evaluator_.value(0, *s.exact());
  return Real([*this, s](long bits) { return enclose(s.enclose(bits + 8), bits); });
}

// G(m) + (s − m)/V with an exact m of the ball.
RealBall TimeOfLength::enclose(const RealBall& s, long bits) const {
  const Rational m = std::max(Rational(0), s.lower());
  const RealBall rest = subtract(s, RealBall(m, bits + 8), bits + 8);
  const RealBall all = hull(m, s.upper(), bits + 8);
  return add(evaluator_.difference(0, m, bits + 8),
             divide(rest, evaluate(speed_, all, bits + 8), bits + 8), bits + 8);
}

RealBall TimeOfLength::rate(const RealBall& s, long bits) const {
  return divide(RealBall(1, bits), evaluate(speed_, s, bits), bits);
}

}  // namespace phrame
