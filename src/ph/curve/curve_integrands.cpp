#include "phrame/ph/curve/curve_integrands.hpp"

#include <utility>

#include "phrame/algebra/real.hpp"

// |v × r′|² = |v|²|r′|² − (v·r′)², e₁′·e₂ does not matter, and e₂′·e₃ = (v × r″)·e₃/|v × r′|, where
// e₃·|v × r′||r′| = r′ × (v × r′) = v|r′|² − (v·r′)r′; (v × r″)·v = 0 leaves −(v·r′)·(v × r″)·r′ =
// (v·r′)·det(v, r′, r″).

namespace phrame::inline v0 {
namespace {

// Each is written once, for a CurveJet and a CurvePoint.

/// p(x).
template <class Function>
Function polynomial_at(const Polynomial& p, const Function& x) {
  Function value = constant_like(x, p.leading_coefficient());
  for (long k = p.degree(); k-- > 0;) value = value * x + constant_like(x, p.coefficient(k));
  return value;
}

/// |r′|/V(x). That V has no pole is asked for, too.
template <class Jet, class Function>
typename Jet::Product time_by(const RationalFunction& speed, const Function& x, const Jet& jet) {
  return {constant_like(x, 1),
          {{jet.square(), 1},
           {polynomial_at(speed.denominator(), x), 2},
           {polynomial_at(speed.numerator(), x), -2}}};
}

// In the plane r′ × r″ is λn, so that one component j tells λ|n| = (r′ × r″)ⱼ·|n|/nⱼ.
template <class Jet>
auto signed_curvature(const Vector<Rational>& normal, const Jet& jet) {
  const std::size_t j = normal[2] != 0 ? 2 : normal[1] != 0 ? 1 : 0;
  const Real scale = square_root_of(dot(normal, normal) / (normal[j] * normal[j]));
  const auto& bend = jet.bend()[j];
  const RealBall size =
      multiply(RealBall(normal[j].sign(), 2), scale.enclose(bend.bits), bend.bits);
  const auto inverse = jet.inverse_speed();
  return constant_like(bend, size) * bend * inverse * (inverse * inverse);
}

template <class Jet>
typename Jet::Product up_frame(const Vector<Rational>& v, const Jet& jet) {
  const auto& like = jet.first()[0];
  const std::array up{constant_like(like, v[0]), constant_like(like, v[1]),
                      constant_like(like, v[2])};
  const auto side = cross(up, jet.first());
  return {dot(up, jet.first()) * dot(side, jet.second()),
          {{dot(side, side), -2}, {jet.square(), -1}}};
}

const DiscFunction& base_of(const DiscFactor& factor) { return factor.base(); }
const PointValue& base_of(const PointFactor& factor) { return factor.base; }

template <class Jet>
typename Jet::Product positive_product(const CurveIntegrand& y, const Jet& jet) {
  const auto one = [&jet] { return constant_like(jet.first()[0], 1); };
  switch (y.kind) {
    case CurveIntegrand::Kind::length:
      return {one(), {{jet.square(), 1}}};
    case CurveIntegrand::Kind::curvature:
      return {one(), {{jet.bend_square(), 1}, {jet.square(), -2}}};
    case CurveIntegrand::Kind::torsion:
      return {jet.volume(), {{jet.square(), 1}, {jet.bend_square(), -2}}};
    case CurveIntegrand::Kind::bending:
      return {base_of(jet.bend_square()), {{jet.square(), -5}}};
    case CurveIntegrand::Kind::squared_torsion:
      return {jet.volume() * jet.volume(), {{jet.square(), 1}, {jet.bend_square(), -4}}};
    case CurveIntegrand::Kind::up_frame:
      return up_frame(y.vector, jet);
    case CurveIntegrand::Kind::time_by_parameter:
      return time_by(y.speed, jet.parameter(), jet);
    case CurveIntegrand::Kind::time_by_curvature:
      break;
  }
  return time_by(y.speed, signed_curvature(y.vector, jet), jet);
}

}  // namespace

DiscProduct CurveIntegrand::operator()(const CurveJet& jet) const {
  DiscProduct product = positive_product(*this, jet);
  if (sign < 0) product.numerator.series = -std::move(product.numerator.series);
  return product;
}

RealBall CurveIntegrand::operator()(const CurvePoint& point) const {
  PointProduct product = positive_product(*this, point);
  if (sign < 0) product.numerator = constant_like(product.numerator, 0) - product.numerator;
  return value(product);
}

CurveIntegrand length_rate() { return {CurveIntegrand::Kind::length}; }
CurveIntegrand curvature_rate() { return {CurveIntegrand::Kind::curvature}; }
CurveIntegrand torsion_rate() { return {CurveIntegrand::Kind::torsion}; }
CurveIntegrand bending_rate() { return {CurveIntegrand::Kind::bending}; }
CurveIntegrand squared_torsion_rate() { return {CurveIntegrand::Kind::squared_torsion}; }

CurveIntegrand up_frame_rate(const Vector<Rational>& v) {
  return {CurveIntegrand::Kind::up_frame, 1, v};
}

CurveIntegrand time_by_parameter(const RationalFunction& speed, const Rational& shift) {
  return {CurveIntegrand::Kind::time_by_parameter, 1, {}, compose(speed, Polynomial{shift, 1})};
}

CurveIntegrand time_by_curvature(const RationalFunction& speed, const Vector<Rational>& normal) {
  return {CurveIntegrand::Kind::time_by_curvature, 1, normal, speed};
}

CurveIntegrand negative(CurveIntegrand y) {
  y.sign = -y.sign;
  return y;
}

}  // namespace phrame
