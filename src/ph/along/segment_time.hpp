#pragma once
#include <variant>

#include "phrame/integrate/evaluator.hpp"
#include "phrame/integrate/integrate.hpp"
#include "phrame/ph/along/segment_integral.hpp"

namespace phrame::inline v0 {

/// The time t ↦ ∫₀ᵗ |r′|/V dt along a segment, t in [0, 1], with a speed V > 0 that is a function
/// of the parameter or of the signed curvature: in closed form along PH curves on which f keeps its
/// sign, where the curvature, if V is one of it, is rational.
class SegmentTime {
 public:
  /// Where dT/dt = |f|σ/V is rational.
  struct ClosedForm {
    RationalFunction rate;          ///< dT/dt
    Antiderivative antiderivative;  ///< of it, so that differences of it are times
    Evaluator evaluator;            ///< of that
  };

  /// @{ In closed form, and as factor times an integral.
  explicit SegmentTime(const RationalFunction& rate)
      : form_(ClosedForm{rate, integrate(rate), {}}) {
    auto& closed = std::get<ClosedForm>(form_);
    closed.evaluator = Evaluator(closed.antiderivative, rate);
  }
  explicit SegmentTime(SegmentIntegral integral, Rational factor = 1)
      : form_(Multiple{std::move(integral), std::move(factor)}) {}
  /// @}

  /// Null where there is none.
  const ClosedForm* closed_form() const { return std::get_if<ClosedForm>(&form_); }
  /// T, exact where it is seen to be rational.
  Real value(const Real& t) const;
  /// A ball around T at a rational t, and at all t of a ball in [0, 1].
  RealBall enclose(const Rational& t, long bits) const;
  RealBall enclose(const RealBall& t, long bits) const;
  /// dT/dt on a ball of t.
  RealBall rate(const RealBall& t, long bits) const;

 private:
  struct Multiple {
    SegmentIntegral integral;
    Rational factor;
  };
  std::variant<ClosedForm, Multiple> form_;
};

/// The same function.
Formula formula_of(const RationalFunction& f);

/// @{ With V a function of the parameter of the path, which is `start` where the segment starts;
/// and of the signed curvature about this normal, which has a positive last component that is not
/// 0. Throws DomainError where V of the curvature is not positive and finite, or the curvature is
/// undefined; Undecided where that is not told, or V of formulas has a zero or pole nearby.
SegmentTime time_by_parameter(const Segment& segment, const RationalFunction& speed,
                              const Rational& start);
SegmentTime time_by_curvature(const Segment& segment, const RationalFunction& speed,
                              const Vector<Rational>& normal, const Rational& start);
/// @}

}  // namespace phrame
