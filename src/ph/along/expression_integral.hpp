#pragma once
#include "phrame/ph/curve/known_integrals.hpp"

namespace phrame::inline v0 {

/// The parts of [0, 1] on which y is analytic, found once for all copies of the curve.
std::shared_ptr<const TaylorParts> taylor_parts(const ExpressionCurve& curve,
                                                const CurveIntegrand& y);
/// Where several integrals along a curve will be asked for, up to its end: finds their parts now
/// and the integrals when the first one is asked for, all on one walk along the curve, on which
/// what they have in common is found once. Nothing else changes by it.
void find_together(const ExpressionCurve& curve, const std::vector<CurveIntegrand>& integrands);

/// t ↦ ∫₀ᵗ y dt along an expression curve, by Taylor polynomials on parts, whose error is bounded
/// by Cauchy's estimate. What is computed is kept for other t and for all copies of the curve. Any
/// thread may ask.
class ExpressionIntegral {
 public:
  /// y is analytic all along; or it is the curvature, whose parts have gaps around inflections, the
  /// smaller the more bits: then enclose() throws Undecided where there are too many.
  ExpressionIntegral(const ExpressionCurve& curve, const CurveIntegrand& y)
      : curve_(curve), y_(y), found_(curve.known_integrals().integral(curve, y)) {}

  /// A ball with a radius of about 2^−bits, t ∈ [0, 1].
  RealBall enclose(const Rational& t, long bits) const;
  /// The same for all t of [0, 1] in a ball, at least one.
  RealBall enclose(const RealBall& t, long bits) const;
  /// y on the ball t.
  RealBall rate(const RealBall& t, long bits) const;

 private:
  ExpressionCurve curve_;
  CurveIntegrand y_;
  std::shared_ptr<KnownIntegrals::Integral> found_;
};

}  // namespace phrame
