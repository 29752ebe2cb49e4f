#pragma once
#include "phrame/ph/along/frame_angle.hpp"
#include "phrame/ph/along/path_angle.hpp"
#include "phrame/ph/along/path_length.hpp"

namespace phrame {

/// The exact minimal twist frame of a spline [Farouki, Moon 2018]: the frame (f₂, f₃) that has the
/// angles θ_i to (e₂, e₃) at the start and θ_f, up to whole turns, at the end, and turns about e₁
/// at a constant rate, with the least total turn:
///   θ(t) = θ_i + T_min·s(t)/S + θ_RMF(t),   θ_RMF′ = −2h/σ,  s(t) the arc length, S = s(end),
///   T = −θ_RMF(end) + θ_f − θ_i ≡ T_min modulo 2π, T_min ∈ (−π, π].
/// To turn by −π is as short as by π: of these π is taken.
class MinimalTwist {
 public:
  /// Whole turns in θ_f − θ_i do not count, however many: they are left out before anything is
  /// rounded. With `extra_turns` ≠ 0 the frame makes that many more revolutions. Throws DomainError
  /// where the multiplier of a segment changes sign on it. Precondition: the angle is that to the
  /// Euler–Rodrigues frame.
  MinimalTwist(const PathAngle& rmf, const FrameAngle& from, const FrameAngle& to,
               const Integer& extra_turns = 0);

  const Rational& length() const { return whole_; }  ///< S
  /// Of segment k, from its start.
  Polynomial arc_length(std::size_t k) const { return length_.closed_form(k)->polynomial(); }
  /// The twist of the Euler–Rodrigues frame, −θ_RMF(end).
  const Real& erf_twist() const { return erf_twist_; }
  const Real& nominal_twist() const { return nominal_; }  ///< T
  /// T_min, plus 2π·extra_turns; exact where it is 0.
  const Real& twist() const { return twist_; }
  /// As ReducedAngle has it, of T_min.
  const std::optional<Rational>& half_turn_within() const { return half_turn_within_; }
  /// The turn per unit of arc length, twist()/S: Ω̄₁.
  Real rate() const;
  const PhPath& path() const { return path_; }   ///< along which it is
  const PathAngle& rmf() const { return rmf_; }  ///< θ_RMF
  /// (θ(end) − θ(0))/2π, where it is a whole number: decided exactly.
  std::optional<Integer> whole_turns_of_theta() const;
  /// θ(t). At the start it is θ_i and at the end θ_f plus whole turns, exactly; where the twist is
  /// 0 it is exact where θ_RMF and θ_i are.
  Real value(const Rational& t) const;
  /// The same less whole turns, so many that θ_i is in (−π, π]: what f₂ and f₃ depend on.
  Real reduced_value(const Rational& t) const;
  /// θ where the arc length from the start is s and θ_RMF is known: θ_i + T_min·s/S + θ_RMF.
  Real value(const Real& s, const Real& rmf_angle) const;

 private:
  Real value(const FrameAngle& start, const Rational& t) const;
  Real value(const FrameAngle& start, const Real& s, const Real& rmf_angle) const;

  PhPath path_;
  PathAngle rmf_;
  FrameAngle from_;
  FrameAngle start_;  ///< θ_i in (−π, π]
  FrameAngle turn_;   ///< θ(end) − θ(0)
  PathLength length_;
  Rational whole_;  ///< S
  Real erf_twist_;
  Real nominal_;
  Real twist_;
  std::optional<Rational> half_turn_within_;
};

}  // namespace phrame
