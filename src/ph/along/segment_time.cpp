#include "phrame/ph/along/segment_time.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "phrame/algebra/ball_order.hpp"
#include "phrame/algebra/decimal_between.hpp"
#include "phrame/algebra/error.hpp"
#include "phrame/ph/along/arc_length.hpp"
#include "phrame/ph/along/feedrate.hpp"
#include "phrame/ph/along/rational_rates.hpp"
#include "phrame/ph/along/up_vector.hpp"

// Along a PH curve V(t), and V(κ) where the unit normal of its plane is rational, are rational
// functions, and so is |f|σ/V. V(t) of another rational curve leaves N/(D√S), an AbsoluteIntegral
// as the length is one. V(t) and V(κ) of formulas, and V(κ) of rational curves as formulas, are
// integrands of Taylor series in balls.

namespace phrame::inline v0 {
namespace {

/// Of an integrand that is analytic where V has no zero and no pole; `refuse` is told where it is
/// not seen to be.
template <class Refuse>
SegmentTime time_of(const ExpressionCurve& curve, const CurveIntegrand& rate,
                    const Refuse& refuse) {
  if (const auto fault = taylor_parts(curve, rate)->fault) refuse(*fault);
  return SegmentTime(SegmentIntegral(ExpressionIntegral(curve, rate)));
}

[[noreturn]] void refuse_near_zero(const Rational& t) {
  throw Undecided(fmt::format("feedrate: the speed is 0 or infinite, or nearly so, near t = {:.9g}",
                              static_cast<double>(t)));
}

SegmentTime time_of(const ExpressionCurve& curve, const RationalFunction& speed,
                    const Rational& start) {
  return time_of(curve, time_by_parameter(speed, start),
                 [&start](const NarrowPart& part) { refuse_near_zero(start + part.lower); });
}

SegmentTime time_of(const RationalCurve& curve, const RationalFunction& speed,
                    const Rational& start) {
  RootQuotient rate = phrame::length_rate(curve);
  const RationalFunction of_t = compose(speed, Polynomial{start, 1});
  rate.numerator *= of_t.denominator();
  rate.denominator *= of_t.numerator();
  return SegmentTime(SegmentIntegral(AbsoluteIntegral(rate)));
}

// ---- V(κ)

Formula polynomial_formula(const Polynomial& p) {
  Formula value(p.leading_coefficient());
  for (long k = p.degree(); k-- > 0;)
    value = value * Formula::variable() + Formula(p.coefficient(k));
  return value;
}

ExpressionCurve by_formulas(const ExpressionCurve& curve) { return curve; }

ExpressionCurve by_formulas(const RationalCurve& curve) {
  if (const auto cusps = real_roots(curve.multiplier(), closed_interval(0, 1)); !cusps.empty())
    throw DomainError("feedrate: the curve has a cusp, where its curvature is undefined");
  const Formula below = polynomial_formula(curve.weight());
  const Vector<Polynomial>& X = curve.numerator();
  return {{polynomial_formula(X[0]) / below, polynomial_formula(X[1]) / below,
           polynomial_formula(X[2]) / below},
          Formula(0),
          Formula(1),
          "t"};
}

/// On a straight line, which has no curvature.
SegmentTime time_of_line(const Segment& segment, const RationalFunction& speed) {
  return SegmentTime(arc_length(segment), 1 / speed_without_curvature(speed));
}

/// The PH curve whose curvature is a rational function: the unit normal is rational and f keeps its
/// sign.
const Curve* with_rational_curvature(const Segment& segment, const Vector<Rational>& normal) {
  const Curve* curve = ph_curve(segment);
  const bool is_one =
      curve != nullptr && square_root(dot(normal, normal)) && has_polynomial_length(*curve);
  return is_one ? curve : nullptr;
}

}  // namespace

Formula formula_of(const RationalFunction& f) {
  const Formula above = polynomial_formula(f.numerator());
  return f.denominator() == Polynomial{1} ? above : above / polynomial_formula(f.denominator());
}

Real SegmentTime::value(const Real& t) const {
  if (const auto* multiple = std::get_if<Multiple>(&form_))
    return multiple->factor * multiple->integral.value(t);
  if (t.exact()) return closed_form()->evaluator.value(0, *t.exact());
  return Real([*this, t](long bits) { return enclose(t.enclose(bits + 8), bits); });
}

RealBall SegmentTime::enclose(const Rational& t, long bits) const {
  if (const ClosedForm* closed = closed_form()) return closed->evaluator.difference(0, t, bits);
  const auto& [integral, factor] = std::get<Multiple>(form_);
  return multiply(RealBall(factor, bits), integral.enclose(t, bits), bits);
}

// T(t) is T(m) + (t − m)·T′ somewhere between m and t.
RealBall SegmentTime::enclose(const RealBall& t, long bits) const {
  const Rational m = std::clamp(t.midpoint(), Rational(0), Rational(1));
  const RealBall off = subtract(t, RealBall(m, bits + 8), bits + 8);
  return add_product(enclose(m, bits), off, rate(t, bits), bits);
}

RealBall SegmentTime::rate(const RealBall& t, long bits) const {
  if (const ClosedForm* closed = closed_form()) return evaluate(closed->rate, t, bits);
  const auto& [integral, factor] = std::get<Multiple>(form_);
  return multiply(RealBall(factor, bits), integral.rate(t, bits), bits);
}

SegmentTime time_by_parameter(const Segment& segment, const RationalFunction& speed,
                              const Rational& start) {
  const Curve* curve = ph_curve(segment);
  if (curve != nullptr && has_polynomial_length(*curve))
    return SegmentTime(travel_time_rate(*curve, {speed, Feedrate::Of::parameter}, start));
  require_positive_along(compose(speed, Polynomial{start, 1}), start);
  return visit_curve([&](const auto& of) { return time_of(of, speed, start); }, segment);
}

SegmentTime time_by_curvature(const Segment& segment, const RationalFunction& speed,
                              const Vector<Rational>& normal, const Rational& start) {
  if (is_straight(Path(segment))) return time_of_line(segment, speed);
  if (const Curve* curve = with_rational_curvature(segment, normal))
    return SegmentTime(travel_time_rate(*curve, {speed, Feedrate::Of::curvature}, start));
  const ExpressionCurve curve =
      visit_curve([](const auto& of) { return by_formulas(of); }, segment);
  const CurveIntegrand rate = time_by_curvature(speed, normal);
  const ExpressionIntegral probe(curve, rate);
  const auto sign_at = [&probe](const Rational& t) {
    return sign(probe.rate(RealBall(t, 256), 256));
  };
  const int first = sign_at(0);
  if (first < 0)
    throw DomainError(fmt::format("feedrate: the speed is negative at t = {}", to_string(start)));
  const SegmentTime time = time_of(curve, rate, [&](const NarrowPart& part) {
    const Rational end = widened_part(part).upper;
    if (first * sign_at(end) < 0)
      throw DomainError("feedrate: the speed is 0 or infinite at t ≈ " +
                        decimal_between(start + part.lower, start + end, 9));
    refuse_near_zero(start + part.lower);
  });
  if (first == 0) refuse_near_zero(start);
  return time;
}

}  // namespace phrame
