#include "phrame/ph/smooth/smooth_point.hpp"

namespace phrame {
namespace {

/// a/b, b ≠ 0.
Real quotient_of(const Real& a, const Real& b) {
  if (a.exact() && b.exact()) return Rational(*a.exact() / *b.exact());
  return Real(
      [a, b](long bits) { return divide(a.enclose(bits + 8), b.enclose(bits + 8), bits + 8); });
}

}  // namespace

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

Vector<Real> cross(const Vector<Real>& u, const Vector<Real>& v) {
  const auto minor = [](const Real& a, const Real& d, const Real& b, const Real& c) {
    return a * d + -(b * c);
  };
  return {minor(u[1], v[2], u[2], v[1]), minor(u[2], v[0], u[0], v[2]),
          minor(u[0], v[1], u[1], v[0])};
}

Real over_square_root(const Real& x, const Real& s) {
  if (x.exact() == Rational(0)) return Rational(0);
  const bool is_exact = x.exact() && s.exact();
  if (is_exact)
    if (const auto root = square_root(*s.exact())) return Rational(*x.exact() / *root);
  const auto enclosure = [x, s](long bits) {
    return divide(x.enclose(bits + 8), sqrt(s.enclose(bits + 8), bits + 8), bits + 8);
  };
  return {enclosure, {is_exact, x.origin().bits + s.origin().bits}};
}

}  // namespace phrame
