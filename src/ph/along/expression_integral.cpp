#include "phrame/ph/along/expression_integral.hpp"

#include <algorithm>

namespace phrame::inline v0 {

std::shared_ptr<const TaylorParts> taylor_parts(const ExpressionCurve& curve,
                                                const CurveIntegrand& y) {
  return curve.known_integrals().parts(curve, y);
}

void find_together(const ExpressionCurve& curve, const std::vector<CurveIntegrand>& integrands) {
  curve.known_integrals().find_together(curve, integrands);
}

RealBall ExpressionIntegral::enclose(const Rational& t, long bits) const {
  const RealBall value = curve_.known_integrals().enclose(curve_, *found_, t, bits);
  return y_.sign < 0 ? subtract({}, value, bits + 64) : value;
}

// F(t) is F(m) + (t − m)·F′ somewhere between m and t.
RealBall ExpressionIntegral::enclose(const RealBall& t, long bits) const {
  const Rational lower = std::clamp(t.lower(), Rational(0), Rational(1));
  const Rational upper = std::clamp(t.upper(), Rational(0), Rational(1));
  const Rational middle = (lower + upper) / 2;
  const RealBall value = enclose(middle, bits);
  if (lower == upper) return value;
  const RealBall all = hull(lower, upper, bits + 8);
  return add_product(value, subtract(all, RealBall(middle, bits + 8), bits), rate(all, bits), bits);
}

RealBall ExpressionIntegral::rate(const RealBall& t, long bits) const {
  return y_(CurvePoint(curve_, t, 1, bits));
}

}  // namespace phrame
