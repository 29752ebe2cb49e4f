#include "phrame/ph/smooth/smooth_point.hpp"

namespace phrame {

Real value(const Polynomial& p, const Real& t) {
  if (t.exact()) return p(*t.exact());
  if (p.is_constant()) return p.coefficient(0);
  return Real([p, t](long bits) { return evaluate(p, t.enclose(bits + 8), bits + 8); });
}

Vector<Real> position(const RationalCurve& curve, const Real& t) {
  const Real below = value(curve.weight(), t);
  const Vector<Polynomial>& X = curve.numerator();
  return {quotient_of(value(X[0], t), below), quotient_of(value(X[1], t), below),
          quotient_of(value(X[2], t), below)};
}

Vector<Real> direction(const RationalCurve& curve, const Real& t) {
  const Vector<Polynomial>& H = curve.direction();
  return {value(H[0], t), value(H[1], t), value(H[2], t)};
}

Vector<Real> position(const SmoothPath& path, const SmoothParameter& at) {
  return std::visit([&](const auto& curve) { return position(curve, at.t); },
                    path.segments()[at.segment]);
}

Vector<Real> direction(const SmoothPath& path, const SmoothParameter& at) {
  return std::visit([&](const auto& curve) { return direction(curve, at.t); },
                    path.segments()[at.segment]);
}

}  // namespace phrame
