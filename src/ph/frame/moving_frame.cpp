#include "phrame/ph/frame/moving_frame.hpp"

#include "phrame/ph/along/reduced_angle.hpp"
#include "phrame/ph/curve/invariants.hpp"

namespace phrame {
namespace {

Real value_at(const RationalFunction& f, const TimedPoint& at) {
  if (at.algebraic) return at.algebraic->value(f);
  if (f.numerator().is_constant() && f.denominator().is_constant())
    return f.numerator().coefficient(0) / f.denominator().coefficient(0);
  return Real(
      [f, t = at.parameter](long bits) { return evaluate(f, t.enclose(bits + 16), bits + 16); });
}

Vector<Real> vector_at(const Vector<RationalFunction>& v, const TimedPoint& at) {
  return {value_at(v[0], at), value_at(v[1], at), value_at(v[2], at)};
}

Vector<RationalFunction> over(const Vector<Polynomial>& v, const Polynomial& sigma) {
  return {RationalFunction(v[0], sigma), RationalFunction(v[1], sigma),
          RationalFunction(v[2], sigma)};
}

}  // namespace

MovingFrame::MovingFrame(const PhPath& path, const FrameStart& start)
    : angle_(path), start_(to_real(reduced(start_angle(start, path)))) {
  for (const Curve& curve : path.segments()) {
    const QuaternionPolynomial a = without_real_content(curve.preimage());
    const Polynomial size = sigma(a);
    frames_.push_back(
        {over(rotated_i(a), size), over(rotated_j(a), size), over(rotated_k(a), size)});
  }
}

Vector<Real> MovingFrame::tangent(const TimedPoint& at) const {
  return vector_at(frames_[at.segment].e1, at);
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
  const auto& [e1, e2, e3] = frames_[at.segment];
  const Frame<Real> erf{vector_at(e1, at), vector_at(e2, at), vector_at(e3, at)};
  return turned(erf, angle(at) + start_);
}

}  // namespace phrame
