#pragma once
#include "phrame/ph/along/path_length.hpp"
#include "phrame/ph/frame/path_frame.hpp"

namespace phrame {

/// The frame of minimal twist along a path of any kind, as MinimalTwist is along a PH path: f₂ has
/// the angles θ_i and θ_f, up to whole turns, to that of v at the start and at the end, and turns
/// about e₁ at a constant rate, with the least total turn:
///   θ(t) = θ_i + T_min·s(t)/S + θ_RMF(t),
///   T = −θ_RMF(end) + θ_f − θ_i ≡ T_min modulo 2π, T_min ∈ (−π, π].
/// Where T_min is not told from ±π, either way is of least twist as far as anybody can tell: then
/// that next to π is taken, and half_turn_within() says so.
/// Copies are cheap and share what was found. To move one is to copy it.
class SmoothTwist {
 public:
  /// A vector of `to` is one at the end. With `extra_turns` ≠ 0 the frame makes that many more
  /// revolutions. Throws DomainError as start_angle(), and for the angle to a Frenet frame.
  SmoothTwist(const PathAngle& rmf, const FrameStart& from, const FrameStart& to,
              const Integer& extra_turns = 0);
  SmoothTwist(const SmoothTwist&) = default;
  SmoothTwist& operator=(const SmoothTwist&) = default;
  ~SmoothTwist() = default;

  const Real& from() const { return from_; }              ///< θ_i
  const Real& to() const { return to_; }                  ///< θ_f
  Real length() const { return whole_; }                  ///< S
  Real up_twist() const;                                  ///< of the frame of v, −θ_RMF(end)
  const Real& nominal_twist() const { return nominal_; }  ///< T
  const Real& twist() const { return twist_; }            ///< T_min, plus 2π·extra_turns
  /// As ReducedAngle has it, of T_min.
  const std::optional<Rational>& half_turn_within() const { return half_turn_within_; }
  Real rate() const;                             ///< the turn per unit of arc length, twist()/S
  const PathAngle& rmf() const { return rmf_; }  ///< θ_RMF

  /// Whether it is the end of the path.
  bool is_end(const Place& at) const;
  /// Whether it is t = 1/2 of a single curve that half a turn maps to itself, which is
  /// is_turned_over_by_half_turn(): there half of both integrals is behind, so that θ is
  /// (θ_i + θ(end))/2, and some components of the frame may be exactly 0.
  bool is_middle(const Place& at) const;
  /// θ(end) = θ_f + 2π·this.
  const Integer& turns_at_end() const { return turns_at_end_; }
  /// θ there: θ_i at the start, and at the end θ_f plus whole turns, exactly.
  Real value(const Place& at) const;

 private:
  PathAngle rmf_;
  PathLength length_;
  Real whole_;
  Real from_;
  Real to_;
  Real nominal_;
  Real twist_;
  std::optional<Rational> half_turn_within_;
  Integer turns_at_end_ = 0;
};

/// The frame of minimal twist there.
Frame<Real> minimal_twist_frame(const SmoothTwist& twist, const Place& at);

}  // namespace phrame
