#include "phrame/ph/frame/frame.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <memory>

#include "phrame/algebra/algebraic_angle.hpp"
#include "phrame/algebra/as_written.hpp"
#include "phrame/algebra/ball_order.hpp"
#include "phrame/algebra/error.hpp"
#include "phrame/ph/curve/real_vector.hpp"
#include "phrame/ph/curve/vector.hpp"

namespace phrame::inline v0 {
namespace {

Vector<Rational> combine(const Rational& x, const Vector<Rational>& a, const Rational& y,
                         const Vector<Rational>& b) {
  return {x * a[0] + y * b[0], x * a[1] + y * b[1], x * a[2] + y * b[2]};
}

/// v/√s, s > 0.
Vector<Real> over_square_root(const Vector<Rational>& v, const Rational& s) {
  const auto root = square_root(s);
  const auto component = [&](const Rational& x) -> Real {
    if (root) return Rational(x / *root);
    if (x == 0) return Rational(0);
    const auto enclosure = [x, s](long bits) {
      return divide(RealBall(x, bits + 8), sqrt(RealBall(s, bits + 8), bits + 8), bits + 8);
    };
    return {enclosure, {true, bits_of(x) + bits_of(s)}};
  };
  return {component(v[0]), component(v[1]), component(v[2])};
}

/// 2θ/π, modulo 4, where that is known to be whole.
std::optional<long> quarter_turns(const Real& theta) {
  if (!theta.origin().angle) return std::nullopt;
  const auto half_turns = over_pi(theta);
  if (!half_turns || denominator(*half_turns * 2) != 1) return std::nullopt;
  const Rational quarters = *half_turns * 2;
  return static_cast<long>(floor(quarters - 4 * Rational(floor(quarters / 4))));
}

Frame<Real> turned_by_quarters(const Frame<Real>& frame, long quarters) {
  const auto& [e1, e2, e3] = frame;
  if (quarters == 1) return {e1, e3, opposite(e2)};
  if (quarters == 2) return {e1, opposite(e2), opposite(e3)};
  if (quarters == 3) return {e1, opposite(e3), e2};
  return frame;
}

}  // namespace

// A real factor c of A leaves the frames alone: it is a factor c² of σ and of g.
Frames::Frames(const Curve& curve) : primitive_(without_real_content(curve.preimage())) {
  bend_ = bend_numerator(primitive_);
}

Frame<Rational> euler_rodrigues_frame(const QuaternionPolynomial& primitive, const Rational& t) {
  const RationalQuaternion a = evaluate(primitive, t);
  const Rational scale = 1 / norm(a);
  const Vector<Rational> zero{};
  return {combine(scale, rotated_i(a), 0, zero), combine(scale, rotated_j(a), 0, zero),
          combine(scale, rotated_k(a), 0, zero)};
}

Frame<Rational> Frames::euler_rodrigues(const Rational& t) const {
  return euler_rodrigues_frame(primitive_, t);
}

void require_bend(const GaussianPolynomial& g) {
  if (is_zero(g))
    throw DomainError("Frenet frame: the curve is a straight line, it has no principal normal");
}

Frame<Real> frenet_frame(const QuaternionPolynomial& primitive, const GaussianPolynomial& bend,
                         const Rational& t) {
  require_bend(bend);
  const Rational re = bend.re(t);
  const Rational im = bend.im(t);
  if (re == 0 && im == 0)
    throw DomainError(fmt::format(
        "Frenet frame: t = {} is an inflection, the principal normal is undefined", as_written(t)));
  return turned(euler_rodrigues_frame(primitive, t), {re, -im});
}

Frame<Real> Frames::frenet(const Rational& t) const { return frenet_frame(primitive_, bend_, t); }

Frame<Real> Frames::rotation_minimizing(const RmfAngle& angle, const Rational& t,
                                        const FrameAngle& start) const {
  return turned(
      euler_rodrigues(t), angle.direction(t),
      [&](const FrameAngle& from) { return angle.value(t, from); }, start);
}

Frame<Real> as_real(const Frame<Rational>& frame) {
  const auto real = [](const Vector<Rational>& v) { return Vector<Real>{v[0], v[1], v[2]}; };
  return {real(frame.e1), real(frame.e2), real(frame.e3)};
}

namespace {

/// x.enclose(bits), or the ball that is known already, if that is as narrow.
RealBall enclosed(const Real& x, long bits) {
  const RealBall* quick = x.quick();
  return quick != nullptr && quick->is_accurate(bits) ? *quick : x.enclose(bits);
}

}  // namespace

Frame<Real> turned(const Frame<Real>& frame, const Real& theta) {
  if (theta.exact() == Rational(0)) return frame;
  if (const auto quarter = quarter_turns(theta)) return turned_by_quarters(frame, *quarter);
  // The six components ask for the same few precisions one after the other: keep the last. Where e₂
  // and e₃ have a component 0 that is not seen to be exact, as few bits of θ do as they leave.
  struct Turn {
    long bits = 0;
    CosSin value;
  };
  const auto last = std::make_shared<Turn>();
  const auto turn = [theta, last](long bits) -> const CosSin& {
    if (last->bits < bits) *last = {bits, cos_sin(enclosed(theta, bits), bits)};
    return last->value;
  };
  // cos θ·x + sin θ·y.
  const auto component = [&](const Real& x, const Real& y) -> Real {
    if (x.exact() == Rational(0) && y.exact() == Rational(0)) return Rational(0);
    const auto enclosure = [x, y, turn](long bits) {
      const RealBall a = x.enclose(bits + 8);
      const RealBall b = y.enclose(bits + 8);
      const long size = std::max(exponent_above(a), exponent_above(b));
      const CosSin& cs = turn(std::max(32L, bits + 8 + std::min(size, 0L)));
      return add(multiply(cs.cos, a, bits + 8), multiply(cs.sin, b, bits + 8), bits + 8);
    };
    return {enclosure, {false, theta.origin().bits + x.origin().bits + y.origin().bits}};
  };
  const auto vector = [&](const Vector<Real>& x, const Vector<Real>& y) {
    return Vector<Real>{component(x[0], y[0]), component(x[1], y[1]), component(x[2], y[2])};
  };
  const Vector<Real>& e2 = frame.e2;
  return {frame.e1, vector(e2, frame.e3), vector(frame.e3, opposite(e2))};
}

Frame<Real> turned(const Frame<Rational>& frame, const GaussianRational& z) {
  const Rational size = norm(z);
  return {{frame.e1[0], frame.e1[1], frame.e1[2]},
          over_square_root(combine(z.re, frame.e2, z.im, frame.e3), size),
          over_square_root(combine(-z.im, frame.e2, z.re, frame.e3), size)};
}

FrameAngle angle_of(const Vector<Rational>& v, const Frame<Rational>& frame) {
  const GaussianRational z{dot(v, frame.e2), dot(v, frame.e3)};
  if (z.re != 0 || z.im != 0) return angle_of(z);
  throw DomainError("the vector " + abbreviated(v) + " has no part in the normal plane" +
                    (dot(v, frame.e1) == 0 ? "" : ": it is along the tangent"));
}

Frame<Real> turned(const Frame<Rational>& frame, const std::optional<GaussianRational>& direction,
                   const std::function<Real(const FrameAngle& start)>& theta,
                   const FrameAngle& start) {
  const auto from = direction_of(start);
  if (direction && from) return turned(frame, *direction * *from);
  if (from) return turned(turned(frame, *from), theta({}));
  return turned(as_real(frame), theta(start));
}

Frame<Rational> euler_rodrigues_frame(const Curve& curve, const Rational& t) {
  return euler_rodrigues_frame(without_real_content(curve.preimage()), t);
}

Frame<Real> frenet_frame(const Curve& curve, const Rational& t) { return Frames(curve).frenet(t); }

Frame<Real> rotation_minimizing_frame(const Curve& curve, const RmfAngle& angle,
                                      const Rational& t) {
  return Frames(curve).rotation_minimizing(angle, t);
}

Vector<double> round_to_double(const Vector<Real>& v) {
  return {round_to_double(v[0]), round_to_double(v[1]), round_to_double(v[2])};
}

Vector<double> round_to_double(const Vector<Rational>& v) {
  return round_to_double(Vector<Real>{v[0], v[1], v[2]});
}

}  // namespace phrame
