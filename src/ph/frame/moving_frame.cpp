#include "phrame/ph/frame/moving_frame.hpp"

#include "phrame/ph/along/reduced_angle.hpp"
#include "phrame/ph/curve/invariants.hpp"

namespace phrame {
namespace {

Vector<Real> vector_at(const Vector<RationalFunction>& v, const Place& at) {
  return {value(v[0], at), value(v[1], at), value(v[2], at)};
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

Vector<Real> MovingFrame::tangent(const Place& at) const {
  return vector_at(frames_[at.segment].e1, at);
}

Frame<Real> MovingFrame::at(const Place& at) const {
  const auto& [e1, e2, e3] = frames_[at.segment];
  const Frame<Real> erf{vector_at(e1, at), vector_at(e2, at), vector_at(e3, at)};
  return turned(erf, angle_.value(at) + start_);
}

}  // namespace phrame
