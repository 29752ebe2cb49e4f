#pragma once
#include <memory>
#include <variant>

#include "phrame/export.hpp"
#include "phrame/ph/curve/curve.hpp"
#include "phrame/ph/curve/expression_curve.hpp"
#include "phrame/ph/curve/rational_curve.hpp"

namespace phrame::inline v0 {

/// A PH curve as a segment of a path: by its preimage and, where that is asked for, by its
/// positions. Copies share these.
class PHRAME_API PhSegment {
 public:
  /// That curve, on [0, 1].
  explicit PhSegment(Curve curve);

  const Curve& curve() const;  ///< the curve
  /// The same by its positions: H is along A i A*, p has the sign of f. Cost: that of r and of the
  /// greatest common divisor of r′, in the first call.
  const RationalCurve& by_positions() const;
  /// A without its greatest real factor, for frames, which go on through cusps. Found in the first
  /// call.
  const QuaternionPolynomial& primitive_preimage() const;
  const GaussianPolynomial& bend() const;  ///< g of that, found likewise

  /// The same with A·j and −f, whose e₁ is reversed.
  PhSegment turned_over() const { return PhSegment(phrame::turned_over(curve())); }

  /// Have they the same preimage, multiplier and start?
  friend bool operator==(const PhSegment& a, const PhSegment& b) { return a.curve() == b.curve(); }

 private:
  struct State;

  std::shared_ptr<const State> state_;
};

/// A segment of a path of curves of any kind, on [0, 1].
using Segment = std::variant<RationalCurve, ExpressionCurve, PhSegment>;

/// @{ The curve that the segment is, where it is one: null for others. A PH curve is a curve X/W,
/// too, and either polynomial or rational.
PHRAME_API const Curve* ph_curve(const Segment& segment);
PHRAME_API const RationalCurve* rational_curve(const Segment& segment);
/// @}

/// f(curve) of the RationalCurve or the ExpressionCurve that the segment is.
template <class F>
decltype(auto) visit_curve(const F& f, const Segment& segment) {
  if (const RationalCurve* curve = rational_curve(segment)) return f(*curve);
  return f(std::get<ExpressionCurve>(segment));
}

/// 1 where e₁ is the unit tangent r′/|r′| just after the start of the segment, −1 where it is the
/// opposite.
PHRAME_API int orientation(const Segment& segment);
/// The same just before its end.
PHRAME_API int end_orientation(const Segment& segment);
/// The same segment with −e₁.
PHRAME_API Segment turned_over(const Segment& segment);

}  // namespace phrame
