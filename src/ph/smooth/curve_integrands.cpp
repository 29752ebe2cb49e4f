#include "phrame/ph/smooth/curve_integrands.hpp"

#include "phrame/algebra/real.hpp"

// |v × r′|² = |v|²|r′|² − (v·r′)², e₁′·e₂ does not matter, and e₂′·e₃ = (v × r″)·e₃/|v × r′|, where
// e₃·|v × r′||r′| = r′ × (v × r′) = v|r′|² − (v·r′)r′; (v × r″)·v = 0 leaves −(v·r′)·(v × r″)·r′ =
// (v·r′)·det(v, r′, r″).

namespace phrame {
namespace {

/// p(x).
DiscFunction polynomial_at(const Polynomial& p, const DiscFunction& x) {
  DiscFunction value = constant_like(x, p.leading_coefficient());
  for (long k = p.degree(); k-- > 0;) value = value * x + constant_like(x, p.coefficient(k));
  return value;
}

/// |r′|/V(x). That V has no pole is asked for, too.
DiscProduct time_by(const RationalFunction& speed, const DiscFunction& x, const CurveJet& jet) {
  return {constant_like(x, 1),
          {{dot(jet.first, jet.first), 1},
           {polynomial_at(speed.denominator(), x), 2},
           {polynomial_at(speed.numerator(), x), -2}}};
}

}  // namespace

CurveIntegrand length_rate() {
  return [](const CurveJet& jet) {
    return DiscProduct{constant_like(jet.first[0], 1), {{dot(jet.first, jet.first), 1}}};
  };
}

CurveIntegrand curvature_rate() {
  return [](const CurveJet& jet) {
    const Vector<DiscFunction> bend = cross(jet.first, jet.second);
    return DiscProduct{constant_like(jet.first[0], 1),
                       {{dot(bend, bend), 1}, {dot(jet.first, jet.first), -2}}};
  };
}

CurveIntegrand torsion_rate() {
  return [](const CurveJet& jet) {
    const Vector<DiscFunction> bend = cross(jet.first, jet.second);
    return DiscProduct{dot(bend, jet.third),
                       {{dot(jet.first, jet.first), 1}, {dot(bend, bend), -2}}};
  };
}

CurveIntegrand bending_rate() {
  return [](const CurveJet& jet) {
    const Vector<DiscFunction> bend = cross(jet.first, jet.second);
    return DiscProduct{dot(bend, bend), {{dot(jet.first, jet.first), -5}}};
  };
}

CurveIntegrand frenet_energy_rate() {
  return [](const CurveJet& jet) {
    const Vector<DiscFunction> bend = cross(jet.first, jet.second);
    const DiscFunction sigma = dot(jet.first, jet.first);
    const DiscFunction rho = dot(bend, bend);
    const DiscFunction volume = dot(bend, jet.third);
    return DiscProduct{rho * rho * rho + sigma * sigma * sigma * volume * volume,
                       {{sigma, -5}, {rho, -4}}};
  };
}

CurveIntegrand up_frame_rate(const Vector<Rational>& v) {
  return [v](const CurveJet& jet) {
    const DiscFunction& like = jet.first[0];
    const Vector<DiscFunction> up{constant_like(like, v[0]), constant_like(like, v[1]),
                                  constant_like(like, v[2])};
    const Vector<DiscFunction> side = cross(up, jet.first);
    return DiscProduct{dot(up, jet.first) * dot(side, jet.second),
                       {{dot(side, side), -2}, {dot(jet.first, jet.first), -1}}};
  };
}

CurveIntegrand time_by_parameter(const RationalFunction& speed, const Rational& shift) {
  const RationalFunction of_t = compose(speed, Polynomial{shift, 1});
  return [of_t](const CurveJet& jet) { return time_by(of_t, parameter_of(jet), jet); };
}

// In the plane r′ × r″ is λn, so that one component j tells λ|n| = (r′ × r″)ⱼ·|n|/nⱼ.
CurveIntegrand time_by_curvature(const RationalFunction& speed, const Vector<Rational>& normal) {
  const std::size_t j = normal[2] != 0 ? 2 : normal[1] != 0 ? 1 : 0;
  const Real scale = square_root_of(dot(normal, normal) / (normal[j] * normal[j]));
  const int sign = normal[j].sign();
  return [speed, j, scale, sign](const CurveJet& jet) {
    const DiscFunction& like = jet.first[0];
    const std::size_t k = (j + 1) % 3;
    const std::size_t l = (j + 2) % 3;
    const RealBall size = multiply(RealBall(sign, 2), scale.enclose(like.bits), like.bits);
    const DiscFunction factor{BallPolynomial({size}), absolute(size), like.length, like.bits};
    const DiscFunction bend = jet.first[k] * jet.second[l] - jet.first[l] * jet.second[k];
    const DiscFunction inverse = inverse_speed(jet);
    return time_by(speed, factor * bend * inverse * (inverse * inverse), jet);
  };
}

CurveIntegrand negative(const CurveIntegrand& y) {
  return [y](const CurveJet& jet) {
    DiscProduct product = y(jet);
    product.numerator = constant_like(product.numerator, 0) - product.numerator;
    return product;
  };
}

}  // namespace phrame
