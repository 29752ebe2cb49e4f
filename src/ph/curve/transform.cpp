// With w(t) = a + (b − a)t, (r∘w)′ = (b − a)·(f∘w)·(A∘w) i (A∘w)*. And U(f·A i A*)U* = f·(UA) i
// (UA)*.
#include "phrame/ph/curve/transform.hpp"

#include "phrame/algebra/as_written.hpp"
#include "phrame/algebra/error.hpp"

namespace phrame {
namespace {

Vector<Rational> sum(const Vector<Rational>& a, const Vector<Rational>& b) {
  return {a[0] + b[0], a[1] + b[1], a[2] + b[2]};
}

Vector<Rational> multiple(const Rational& c, const Vector<Rational>& v) {
  return {c * v[0], c * v[1], c * v[2]};
}

}  // namespace

Curve segment(const Curve& curve, const Rational& a, const Rational& b) {
  if (a == b)
    throw DomainError("segment: its ends are equal, t = " + as_written(a) + ", so it is a point");
  const Polynomial w{a, b - a};
  const auto& [u, v, p, q] = curve.preimage();
  return Curve({compose(u, w), compose(v, w), compose(p, w), compose(q, w)},
               Rational(b - a) * compose(curve.multiplier(), w), evaluate(position(curve), a));
}

Curve reversed(const Curve& curve) { return segment(curve, 1, 0); }

Curve translated(const Curve& curve, const Vector<Rational>& v) {
  return Curve(curve.preimage(), curve.multiplier(), sum(curve.start(), v));
}

Curve scaled(const Curve& curve, const Rational& c) {
  if (c == 0) throw DomainError("scaled: the factor is 0, so the curve is a point");
  return Curve(curve.preimage(), c * curve.multiplier(), multiple(c, curve.start()));
}

Curve rotated(const Curve& curve, const RationalQuaternion& u) {
  if (norm(u) == 0) throw DomainError("rotated: the quaternion is 0, so the curve is a point");
  const QuaternionPolynomial constant{{u.u}, {u.v}, {u.p}, {u.q}};
  const auto& [x, y, z] = curve.start();
  return Curve(
      constant * curve.preimage(), curve.multiplier(),
      sum(sum(multiple(x, rotated_i(u)), multiple(y, rotated_j(u))), multiple(z, rotated_k(u))));
}

}  // namespace phrame
