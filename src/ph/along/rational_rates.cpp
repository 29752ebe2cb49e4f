#include "phrame/ph/along/rational_rates.hpp"

#include "phrame/algebra/error.hpp"
#include "phrame/algebra/factor.hpp"
#include "phrame/ph/curve/invariants.hpp"
#include "phrame/ph/curve/shape.hpp"
#include "phrame/ph/curve/vector.hpp"

// |v × H|² = |v|²σ − (v·H)². Where H × H′ = g·B with a real polynomial g and B ≠ 0, the Frenet
// frame goes on by that of B: (H × H′) × (H × H″) = det(H, H′, H″)·H = g²·B × B′, so that g²
// cancels in det(H, H′, H″)/ρ.

namespace phrame::inline v0 {
namespace {

Polynomial squared_size(const Vector<Polynomial>& v) { return dot(v, v); }

/// c·p; most c of up vectors are 0 or ±1.
Polynomial multiple(const Rational& c, const Polynomial& p) {
  if (c == 1) return p;
  return c == 0 ? Polynomial() : c * p;
}
/// a·p − b·q.
Polynomial difference(const Rational& a, const Polynomial& p, const Rational& b,
                      const Polynomial& q) {
  return b == 0 ? multiple(a, p) : a == 0 ? multiple(-b, q) : a * p - b * q;
}

}  // namespace

Turning turning_of(const RationalCurve& curve) {
  const Vector<Polynomial> b = binormal(curve);
  return {squared_size(curve.direction()), squared_size(b),
          dot(b, differentiate(differentiate(curve.direction())))};
}

Vector<Polynomial> across(const Vector<Rational>& v, const RationalCurve& curve) {
  const Vector<Polynomial>& H = curve.direction();
  return {difference(v[1], H[2], v[2], H[1]), difference(v[2], H[0], v[0], H[2]),
          difference(v[0], H[1], v[1], H[0])};
}

RootQuotient up_frame_turning(const RationalCurve& curve, const Vector<Rational>& v) {
  const Vector<Polynomial>& H = curve.direction();
  const Vector<Polynomial> normal = across(v, curve);
  Polynomial along;
  for (std::size_t k = 0; k < 3; ++k)
    if (v[k] != 0) along += multiple(v[k], H[k]);
  return {-along * dot(normal, differentiate(H)), squared_size(normal), squared_size(H)};
}

RootQuotient frenet_turning(const RationalCurve& curve) {
  const auto [sigma, rho, volume] = turning_of(curve);
  if (rho.is_zero())
    throw DomainError("Frenet frame: the curve is a straight line, it has no principal normal");
  return {-volume * sigma, rho, sigma};
}

RootQuotient length_rate(const RationalCurve& curve) {
  const Polynomial sigma = squared_size(curve.direction());
  return {curve.multiplier() * sigma, curve.weight() * curve.weight(), sigma};
}

namespace {

/// √ρ/σ up to a sign: ρ = c·g²·ρ₁ with ρ₁ squarefree, without a real zero: √ρ = g·c·ρ₁/√(c·ρ₁).
RootQuotient root_over(const Polynomial& rho, const Polynomial& sigma) {
  if (rho.is_zero()) return {};
  Polynomial g{1};
  Polynomial rest{1};
  const Factorization factors = squarefree_factorization(rho);
  for (const Factor& factor : factors.factors) {
    g *= pow(factor.base, factor.exponent / 2);
    if (factor.exponent % 2 != 0) rest *= factor.base;
  }
  rest *= factors.unit;
  return {g * rest, sigma, rest};
}

}  // namespace

RootQuotient curvature_rate(const RationalCurve& curve) {
  return root_over(squared_size(binormal(curve)), squared_size(curve.direction()));
}

RootQuotient curvature_rate(const QuaternionPolynomial& preimage) {
  return root_over(rho(preimage), sigma(preimage));
}

RootQuotient bending_rate(const RationalCurve& curve) {
  const Polynomial sigma = squared_size(curve.direction());
  return {squared_size(binormal(curve)) * curve.weight() * curve.weight(),
          curve.multiplier() * sigma * sigma, sigma};
}

RootQuotient frenet_energy_rate(const RationalCurve& curve) {
  const auto [sigma, rho, volume] = turning_of(curve);
  if (rho.is_zero()) throw DomainError("torsion: the curve is a straight line, it has none");
  const Polynomial turn = volume * curve.weight();
  return {pow(rho, 3) * pow(curve.weight(), 2) + pow(sigma, 3) * turn * turn,
          curve.multiplier() * pow(sigma * rho, 2), sigma};
}

}  // namespace phrame
