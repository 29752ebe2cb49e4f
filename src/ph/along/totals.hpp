#pragma once
#include <variant>

#include "phrame/export.hpp"
#include "phrame/integrate/definite_integral.hpp"
#include "phrame/ph/curve/curve.hpp"

namespace phrame::inline v0 {

/// An integral along a curve on [0, 1], in closed form:
///   √radicand · ∫₀¹ ±rate dt = √radicand · Σ ±(F(b) − F(a))
/// over the parts [a, b] between the sign changes. On the first part the sign is +.
struct CurveTotal {
  Rational radicand;                        ///< > 0
  RationalFunction rate;                    ///< without a pole on [0, 1]
  Antiderivative antiderivative;            ///< F, of the rate
  std::vector<RealAlgebraic> sign_changes;  ///< of what is integrated, in (0, 1)
  Real value;                               ///< exact where it is seen to be rational
  std::optional<ExactValue> exact;          ///< of value/√radicand, where known in finite terms
};

/// A total that is infinite, with a pole of the rate on [0, 1], which is not negative.
struct Infinite {
  RealAlgebraic pole;       ///< the first one
  std::size_t segment = 0;  ///< of a path, whose parameter the pole is then
  friend bool operator==(const Infinite&, const Infinite&) = default;
};

/// ∫ ds = ∫|f|σ dt.
PHRAME_API CurveTotal total_length(const Curve& curve);
/// ∫₀¹ 2h/σ dt: how far the Euler–Rodrigues frame turns about e₁, in radians. −θ_ERF(1).
PHRAME_API CurveTotal erf_twist(const Curve& curve);
/// ∫ κ² ds = ∫ ρ/(|f|σ³) dt, infinite at most cusps.
PHRAME_API std::variant<CurveTotal, Infinite> bending_energy(const Curve& curve);
/// ∫ (κ² + τ²) ds, infinite at most cusps; at inflections τ is finite, since g = c·g₀ with a real c
/// makes Im(g′/g) = Im(g₀′/g₀). Throws DomainError for a straight line.
PHRAME_API std::variant<CurveTotal, Infinite> frenet_energy(const Curve& curve);
/// ∫ τ ds = ±∫ (2h/σ − Im(g′/g)) dt, the sign that of f, in radians; the half turns of n and b at
/// inflections are not in it. ∓θ_Frenet(1) where f does not change sign. Throws DomainError for a
/// straight line.
PHRAME_API CurveTotal total_torsion(const Curve& curve);
/// ∫ κ ds = ∫ √ρ/σ dt for ρ = cω²: how far the tangent turns, in radians, without the half turns at
/// cusps. No value where ρ is no square (double_ph).
PHRAME_API std::optional<CurveTotal> total_curvature(const Curve& curve);

}  // namespace phrame
