#pragma once
#include <optional>

#include "phrame/export.hpp"
#include "phrame/ph/twist/minimal_twist.hpp"

namespace phrame::inline v0 {

/// What the rational rotations of a piece have to meet beside the orientations at its ends.
enum class EndRates {
  matched,  ///< the rate of the exact frame at both ends: joints then have a continuous rate
  free,
};

/// A piece of a curve and the turn that a frame is to make along it, with a parameter τ ∈ [0, 1] of
/// its own. A frame that is the Euler–Rodrigues frame turned by θ(τ) about e₁ turns about e₁ by
///   2h/σ + θ′ = erf_rate + θ′  per unit of τ,
/// and at a constant rate along the curve where that is T·speed [Farouki, Moon 2018, (23), (39)].
struct PHRAME_API TwistPiece {
  Rational from;              ///< the parameters of the curve or spline at τ = 0 and 1
  Rational to;                ///< > from
  RationalFunction erf_rate;  ///< 2h/σ, with dt = (to − from) dτ
  Polynomial speed;  ///< |r′| per unit of τ and of the length: > 0 on [0, 1], ∫₀¹ = 1
  Rational length;   ///< ΔS, the arc length
  Real twist;        ///< T, the turn about e₁ that is wanted
  Real turn;         ///< θ(1) − θ(0) = T − ∫₀¹ 2h/σ
  std::optional<Integer> whole_turns;  ///< where it is known: turn = 2π·whole_turns, exactly
  Real start;                          ///< θ(0), counted from a θ_i in (−π, π]
  /// ∫₀^τ 2h/σ.
  std::function<Real(const Rational& tau)> erf_twist;

  /// @{ What θ′ is at the ends where the frame turns at the constant rate there,
  /// T·speed − erf_rate: ρ₀ and ρ₁ of (33).
  Real first_rate() const;
  Real last_rate() const;
  /// @}
};

/// Throws DomainError where the angle is not that to the Euler–Rodrigues frame, which a rational
/// frame is turned from.
PHRAME_API void require_to_erf(const MinimalTwist& mtf);

/// The pieces of the curve or spline between its joints and the points given, in any order, others
/// than the ends ignored: each has its share of the twist (39), and the angles between them are
/// those of the exact frame of minimal twist (40). Throws DomainError for a point outside [0, end],
/// where the curve has a cusp, at which a turn per unit of length is infinite, and as
/// require_to_erf().
PHRAME_API std::vector<TwistPiece> twist_pieces(const MinimalTwist& mtf,
                                                std::vector<Rational> points);

/// All of a curve, along which a frame is not to turn at all: T = 0, θ that of the
/// rotation-minimizing frame. Throws DomainError as twist_pieces() does, and where the multiplier
/// changes sign on [0, 1].
PHRAME_API TwistPiece untwisted_piece(const Curve& curve);

/// A piece divided at points inside it, in any order: its own pieces.
PHRAME_API std::vector<TwistPiece> divided(const MinimalTwist& mtf, const TwistPiece& piece,
                                           std::vector<Rational> points);

}  // namespace phrame
