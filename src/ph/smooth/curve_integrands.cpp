#include "phrame/ph/smooth/curve_integrands.hpp"

// |v × r′|² = |v|²|r′|² − (v·r′)², e₁′·e₂ does not matter, and e₂′·e₃ = (v × r″)·e₃/|v × r′|, where
// e₃·|v × r′||r′| = r′ × (v × r′) = v|r′|² − (v·r′)r′; (v × r″)·v = 0 leaves −(v·r′)·(v × r″)·r′ =
// (v·r′)·det(v, r′, r″).

namespace phrame {

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

CurveIntegrand negative(const CurveIntegrand& y) {
  return [y](const CurveJet& jet) {
    DiscProduct product = y(jet);
    product.numerator = constant_like(product.numerator, 0) - product.numerator;
    return product;
  };
}

}  // namespace phrame
