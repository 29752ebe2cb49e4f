#include "phrame/ph/curve/invariants.hpp"

#include "phrame/algebra/as_written.hpp"
#include "phrame/algebra/error.hpp"
#include "phrame/algebra/factor.hpp"

namespace phrame::inline v0 {

Polynomial sigma(const QuaternionPolynomial& a) { return norm(a); }

Polynomial twist_numerator(const QuaternionPolynomial& a) {
  return a.u * differentiate(a.v) - differentiate(a.u) * a.v - a.p * differentiate(a.q) +
         differentiate(a.p) * a.q;
}

GaussianPolynomial bend_numerator(const QuaternionPolynomial& a) {
  const auto [alpha, beta] = hopf_form(a);
  return alpha * differentiate(beta) - differentiate(alpha) * beta;
}

Polynomial rho(const QuaternionPolynomial& a) { return Rational(4) * norm(bend_numerator(a)); }

std::optional<DoublePh> double_ph(const QuaternionPolynomial& a) {
  const Polynomial squared_bend = rho(a);
  DoublePh result{0, {1}};
  if (squared_bend.is_zero()) return result;
  const auto [unit, factors] = squarefree_factorization(squared_bend);
  result.constant = unit;
  for (const auto& [base, exponent] : factors) {
    if (exponent % 2 != 0) return std::nullopt;
    result.omega *= pow(base, exponent / 2);
  }
  return result;
}

AngleSplit closed_split(const QuaternionPolynomial& preimage) {
  const GaussianPolynomial g = bend_numerator(preimage);
  return {Rational(2) * twist_numerator(preimage),
          Rational(-4) * (differentiate(g) * conjugate(g)).im};
}

Polynomial triple_product(const Curve& curve) {
  if (!curve.is_polynomial()) throw DomainError("triple product: the curve is rational");
  const QuaternionPolynomial& preimage = curve.preimage();
  const auto [a, b] = closed_split(preimage);
  return pow(curve.multiplier(), 3) * (a * rho(preimage) + b * sigma(preimage));
}

RationalFunction squared_curvature(const Curve& curve) {
  const QuaternionPolynomial& a = curve.preimage();
  return {rho(a) * pow(curve.weight(), 4), pow(curve.multiplier(), 2) * pow(sigma(a), 4)};
}

namespace {

[[noreturn]] void refuse_torsion() {
  throw DomainError("torsion: the curve is a straight line, its torsion is undefined");
}

}  // namespace

RationalFunction torsion(const Curve& curve) {
  const QuaternionPolynomial& a = curve.preimage();
  const Polynomial squared_bend = rho(a);
  if (squared_bend.is_zero()) refuse_torsion();
  const auto [of_bend, of_speed] = closed_split(a);
  const Polynomial speed = sigma(a);
  return {(of_bend * squared_bend + of_speed * speed) * pow(curve.weight(), 2),
          curve.multiplier() * pow(speed, 2) * squared_bend};
}

// τ = (2hρ − 4 Im(g′ḡ)σ)/(fσ²ρ).
RationalFunction frenet_rate_by_t(const Curve& curve) {
  const QuaternionPolynomial& a = curve.preimage();
  const Polynomial squared_bend = rho(a);
  if (squared_bend.is_zero()) refuse_torsion();
  const Polynomial speed = sigma(a);
  const auto [of_bend, of_speed] = closed_split(a);
  return {(pow(squared_bend, 3) + pow(of_bend * squared_bend + of_speed * speed, 2)) *
              pow(curve.weight(), 2),
          curve.multiplier() * pow(speed, 3) * pow(squared_bend, 2)};
}

RationalFunction squared_frenet_rate(const Curve& curve) {
  return frenet_rate_by_t(curve) *
         RationalFunction(pow(curve.weight(), 2), curve.multiplier() * sigma(curve.preimage()));
}

// With d = A i A*: r′ = f·d, r′ × r″ = f²·d × d′ and |r′|³ = |f|³σ³, so κ = (d × d′)·n/(|f|σ³). In
// a plane d × d′ = w·N with a constant N ∈ ℚ³.
RationalFunction signed_curvature(const Curve& curve) {
  const Signs signs = multiplier_signs(curve);
  if (signs.positive && signs.negative)
    throw DomainError("signed curvature: the multiplier changes sign on [0, 1]");
  const Vector<Polynomial> d = rotated_i(curve.preimage());
  const auto minor = [&](std::size_t j, std::size_t k) {
    return d[j] * differentiate(d[k]) - d[k] * differentiate(d[j]);
  };
  const Vector<Polynomial> normal{minor(1, 2), minor(2, 0), minor(0, 1)};
  std::size_t last = 2;
  while (last > 0 && normal[last].is_zero()) --last;
  const Polynomial& w = normal[last];
  if (w.is_zero()) return {};
  Rational square = 0;  // |N|², N = normal/w
  for (const Polynomial& component : normal) {
    const Rational ratio = component.coefficient(w.degree()) / w.leading_coefficient();
    if (!(component == ratio * w)) throw DomainError("signed curvature: the curve is not plane");
    square += ratio * ratio;
  }
  const auto length = square_root(square);
  if (!length)
    throw DomainError("signed curvature: the unit normal of the plane is not rational, |N|² = " +
                      as_written(square));
  const Polynomial f = signs.negative ? -curve.multiplier() : curve.multiplier();
  return {*length * w * pow(curve.weight(), 2), f * pow(sigma(curve.preimage()), 3)};
}

}  // namespace phrame
