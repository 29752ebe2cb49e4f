#include "phrame/ph/frame/moving_frame.hpp"

#include "phrame/ph/curve/invariants.hpp"
#include "phrame/ph/frame/reduced_angle.hpp"

namespace phrame {
namespace {

Real quotient_at(const Polynomial& above, const Polynomial& below, const TimedPoint& at) {
  const RationalFunction f(above, below);
  if (at.algebraic) return at.algebraic->value(f);
  if (f.numerator().is_constant() && f.denominator().is_constant())
    return f.numerator().coefficient(0) / f.denominator().coefficient(0);
  return Real(
      [f, t = at.parameter](long bits) { return evaluate(f, t.enclose(bits + 16), bits + 16); });
}

}  // namespace

MovingFrame::MovingFrame(const Path& path, const FrameStart& start)
    : angle_(path), start_(to_real(reduced(start_angle(start, path)))) {
  for (const Curve& curve : path.segments()) {
    const QuaternionPolynomial a = without_real_content(curve.preimage());
    segments_.push_back({{rotated_i(a), rotated_j(a), rotated_k(a)}, sigma(a)});
  }
}

Vector<Real> MovingFrame::vector(const Vector<Polynomial>& numerator, const TimedPoint& at) const {
  const Polynomial& sigma = segments_[at.segment].sigma;
  return {quotient_at(numerator[0], sigma, at), quotient_at(numerator[1], sigma, at),
          quotient_at(numerator[2], sigma, at)};
}

Vector<Real> MovingFrame::tangent(const TimedPoint& at) const {
  return vector(segments_[at.segment].numerators.e1, at);
}

/// θ at a rational number m next to t, and θ′·(t − m) with θ′ on a ball that holds both.
Real MovingFrame::angle(const TimedPoint& at) const {
  const std::size_t k = at.segment;
  if (at.parameter.exact()) return angle_.value(PathParameter{k, *at.parameter.exact()});
  const RationalFunction& rate = angle_.segment(k).rate();
  if (rate.is_zero()) return angle_.value(PathParameter{k, Rational(0)});
  const auto enclosure = [angle = angle_, rate, k, t = at.parameter](long bits) {
    const RealBall near = t.enclose(bits + 16);
    const Rational m = near.midpoint();
    const RealBall way = subtract(near, RealBall(m, bits + 64), bits + 16);
    return add(angle.enclose(PathParameter{k, m}, bits + 16),
               multiply(evaluate(rate, near, bits + 16), way, bits + 16), bits + 16);
  };
  return Real(enclosure, {false, bits_of(rate)});
}

Frame<Real> MovingFrame::at(const TimedPoint& at) const {
  const Frame<Polynomial>& numerators = segments_[at.segment].numerators;
  const Frame<Real> erf{vector(numerators.e1, at), vector(numerators.e2, at),
                        vector(numerators.e3, at)};
  return turned(erf, angle(at) + start_);
}

}  // namespace phrame
