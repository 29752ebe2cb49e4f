#pragma once
#include <array>
#include <optional>
#include <variant>

#include "phrame/ph/offset/gauge.hpp"

namespace phrame::inline v0 {

/// φ = p/q along a curve, with p and q ∈ ℚ[t] without a common root; ∞ where q = 0.
struct GaugeParameter {
  Polynomial p;  ///< the numerator
  Polynomial q;  ///< the denominator
};

/// (x, y)/weight, a polynomial vector over a polynomial.
struct GaugeVector {
  Polynomial x;       ///< its x times the weight
  Polynomial y;       ///< its y times the weight
  Polynomial weight;  ///< without a real zero
};
/// U(p/q), with weight W(p, q) for the form W of the degree of the gauge.
GaugeVector vector_at(const Gauge& gauge, const GaugeParameter& at);

/// Why there is no rational φ(t): the degrees in φ of the factors of r′(t) × U′(φ), irreducible
/// over ℚ, ascending, as often as they occur.
struct NoGaugeParameter {
  std::vector<long> degrees;
  /// c₀, c₁, c₂ of the factor c₀ + c₁φ + c₂φ² that has the φ of both sides for its zeros, where it
  /// is of that degree.
  std::optional<std::array<Polynomial, 3>> both_sides = {};
};

/// c₁² − 4c₀c₂.
Polynomial discriminant(const std::array<Polynomial, 3>& c);

/// φ(t) with U′(φ) ∥ r′, U(φ) to the right of e₁: a factor of degree 1 of r′(t) × U′(φ). As the
/// gauge is traced once, U(φ(t)) is rational where φ(t) is and only there. Precondition: a curve in
/// a plane z = const. Cost: factors of a polynomial in two unknowns.
std::variant<GaugeParameter, NoGaugeParameter> right_parameter(const Gauge& gauge,
                                                               const RationalCurve& curve);

}  // namespace phrame
