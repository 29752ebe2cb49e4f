#include "phrame/ph/along/segment_integral.hpp"

#include <algorithm>

#include "phrame/algebra/error.hpp"
#include "phrame/ph/along/arc_length.hpp"
#include "phrame/ph/along/rational_rates.hpp"
#include "phrame/ph/curve/direction_span.hpp"
#include "phrame/ph/curve/invariants.hpp"
#include "phrame/ph/curve/place.hpp"
#include "phrame/ph/curve/vector.hpp"

// The frame of v does not turn where v is normal to the plane of the curve, and where v is in it:
// then v × H has one direction. det(r′, r″, r‴) is 0 in a plane.

namespace phrame::inline v0 {
namespace {

SegmentIntegral zero_integral() { return {TaylorIntegral(RootQuotient{})}; }

/// Of an integrand that is analytic all along; `refuse` is told where it is not seen to be.
template <class Refuse>
SegmentIntegral integral_of(const ExpressionCurve& curve, const CurveIntegrand& y,
                            const Refuse& refuse) {
  if (const auto fault = taylor_parts(curve, y)->fault) refuse(*fault);
  return {ExpressionIntegral(curve, y)};
}

CurveIntegrand with_sign(int sign, const CurveIntegrand& y) { return sign < 0 ? negative(y) : y; }

[[noreturn]] void refuse_line() {
  throw DomainError("Frenet frame: the curve is a straight line, it has no principal normal");
}

/// Does the form of the curve say that the frame of v does not turn?
bool is_at_rest(const ExpressionCurve& curve, const Vector<Rational>& v) {
  std::vector<Vector<Rational>> span = direction_span(curve);
  const bool is_normal = std::all_of(span.begin(), span.end(),
                                     [&](const auto& direction) { return dot(v, direction) == 0; });
  span.push_back(v);
  return is_normal || common_normal(span);
}

/// Does the form of the curve say that y is 0 all along, or that there is none?
bool is_zero_along(const ExpressionCurve& curve, const CurveIntegrand& y) {
  using Kind = CurveIntegrand::Kind;
  if (y.kind == Kind::length) return false;
  if (y.kind == Kind::up_frame) return is_at_rest(curve, y.vector);
  const auto span = direction_span(curve);
  const bool is_of_torsion = y.kind == Kind::torsion || y.kind == Kind::squared_torsion;
  return are_on_a_line(span) || (is_of_torsion && common_normal(span));
}

SegmentIntegral up_frame_angle_of(const RationalCurve& curve, const Vector<Rational>& v) {
  return {TaylorIntegral(up_frame_turning(curve, v))};
}

SegmentIntegral up_frame_angle_of(const ExpressionCurve& curve, const Vector<Rational>& v) {
  const CurveIntegrand rate = up_frame_rate(v);
  if (is_zero_along(curve, rate)) return zero_integral();
  return integral_of(curve, with_sign(-curve.orientation(), rate), [](const NarrowPart&) {
    throw DomainError("the up vector is along the tangent, or nearly so");
  });
}

SegmentIntegral frenet_angle_of(const RationalCurve& curve) {
  return {TaylorIntegral(frenet_turning(curve))};
}

SegmentIntegral frenet_angle_of(const ExpressionCurve& curve) {
  if (are_on_a_line(direction_span(curve))) refuse_line();
  if (is_zero_along(curve, torsion_rate())) return zero_integral();
  return integral_of(
      curve, with_sign(-curve.orientation(), torsion_rate()),
      [&](const NarrowPart& part) { refuse_inflection(curve, part, "Frenet frame"); });
}

SegmentIntegral arc_length_of(const Curve& curve) {
  const Polynomial rate = curve.multiplier() * sigma(curve.preimage());
  if (!has_polynomial_length(curve)) return {AbsoluteIntegral({rate, {1}, {1}})};
  const Polynomial s = ArcLength(curve).polynomial();
  return {PolynomialIntegral{s, differentiate(s)}};
}

SegmentIntegral arc_length_of(const RationalCurve& curve) {
  return {AbsoluteIntegral(phrame::length_rate(curve))};
}

SegmentIntegral arc_length_of(const ExpressionCurve& curve) {
  return {ExpressionIntegral(curve, length_rate())};
}

SegmentIntegral bending_angle_of(const RationalCurve& curve) {
  return {AbsoluteIntegral(phrame::curvature_rate(curve))};
}

SegmentIntegral bending_angle_of(const ExpressionCurve& curve) {
  if (is_zero_along(curve, curvature_rate())) return zero_integral();
  return {ExpressionIntegral(curve, curvature_rate())};
}

RealBall enclosed(const PolynomialIntegral& f, const Real& t, long bits) {
  return value(f.integral, t).enclose(bits);
}

RealBall enclosed(const AbsoluteIntegral& f, const Real& t, long bits) {
  return f.enclose(t, bits);
}

template <class F>
RealBall enclosed(const F& f, const Real& t, long bits) {
  return t.exact() ? f.enclose(*t.exact(), bits) : f.enclose(t.enclose(bits + 8), bits);
}

RealBall rate_of(const PolynomialIntegral& f, const RealBall& t, long bits) {
  return evaluate(f.rate, t, bits);
}

RealBall rate_of(const AbsoluteIntegral& f, const RealBall& t, long bits) {
  return absolute(f.integral().rate(t, bits));
}

template <class F>
RealBall rate_of(const F& f, const RealBall& t, long bits) {
  return f.rate(t, bits);
}

}  // namespace

bool SegmentIntegral::is_zero() const {
  const auto* f = std::get_if<TaylorIntegral>(&form_);
  return f != nullptr && f->integrand().numerator.is_zero();
}

RealBall SegmentIntegral::enclose(const Real& t, long bits) const {
  return std::visit([&](const auto& f) { return enclosed(f, t, bits); }, form_);
}

RealBall SegmentIntegral::rate(const RealBall& t, long bits) const {
  return std::visit([&](const auto& f) { return rate_of(f, t, bits); }, form_);
}

Real SegmentIntegral::value(const Real& t) const {
  if (t.exact() == Rational(0)) return Rational(0);
  if (const auto* f = std::get_if<PolynomialIntegral>(&form_)) return phrame::value(f->integral, t);
  if (const auto* f = std::get_if<AbsoluteIntegral>(&form_)) return f->value(t);
  if (const auto* f = std::get_if<TaylorIntegral>(&form_); f != nullptr && t.exact())
    return f->value(*t.exact());
  return Real([f = *this, t](long bits) { return f.enclose(t, bits); });
}

std::optional<Surd> SegmentIntegral::algebraic_value(const Rational& t) const {
  if (const auto* f = std::get_if<PolynomialIntegral>(&form_)) return Surd(f->integral(t));
  if (const auto* f = std::get_if<AbsoluteIntegral>(&form_)) return f->algebraic_value(t);
  return std::nullopt;
}

void find_together(const Path& path, const std::vector<CurveIntegrand>& integrands) {
  for (const Segment& segment : path.segments()) {
    const auto* curve = std::get_if<ExpressionCurve>(&segment);
    if (curve == nullptr) continue;
    std::vector<CurveIntegrand> of;
    std::copy_if(integrands.begin(), integrands.end(), std::back_inserter(of),
                 [curve](const CurveIntegrand& y) { return !is_zero_along(*curve, y); });
    find_together(*curve, of);
  }
}

SegmentIntegral up_frame_angle(const Segment& segment, const Vector<Rational>& v) {
  return visit_curve([&](const auto& curve) { return up_frame_angle_of(curve, v); }, segment);
}

SegmentIntegral frenet_angle(const Segment& segment) {
  return visit_curve([](const auto& curve) { return frenet_angle_of(curve); }, segment);
}

SegmentIntegral arc_length(const Segment& segment) {
  const Curve* ph = ph_curve(segment);
  if (ph != nullptr && ph->is_polynomial()) return arc_length_of(*ph);
  return visit_curve([](const auto& curve) { return arc_length_of(curve); }, segment);
}

SegmentIntegral bending_angle(const Segment& segment) {
  if (const auto* ph = std::get_if<PhSegment>(&segment))
    return {AbsoluteIntegral(phrame::curvature_rate(ph->primitive_preimage()))};
  return visit_curve([](const auto& curve) { return bending_angle_of(curve); }, segment);
}

}  // namespace phrame
