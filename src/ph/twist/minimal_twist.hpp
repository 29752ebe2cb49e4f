#pragma once
#include "phrame/export.hpp"
#include "phrame/ph/along/path_length.hpp"
#include "phrame/ph/frame/path_frame.hpp"

namespace phrame::inline v0 {

/// The exact minimal twist frame of a path [Farouki, Moon 2018]: the frame (f₂, f₃) that has the
/// angles θ_i to (e₂, e₃) at the start and θ_f, up to whole turns, at the end, and turns about e₁
/// at a constant rate, with the least total turn:
///   θ(t) = θ_i + T_min·s(t)/S + θ_RMF(t),   s(t) the arc length, S = s(end),
///   T = −θ_RMF(end) + θ_f − θ_i ≡ T_min modulo 2π, T_min ∈ (−π, π].
/// To turn by −π is as short as by π: of these π is taken. Along PH curves it is decided by algebra
/// whether T_min is that, elsewhere where T knows its own form; where it is not told from ±π,
/// either way is of least twist as far as anybody can tell: then that next to π is taken, and
/// half_turn_within() says so. Copies are cheap and share what was found. To move one is to copy
/// it.
class PHRAME_API MinimalTwist {
 public:
  /// Any number of whole turns in θ_f − θ_i does not count; where both are known exactly, whole
  /// turns are left out before anything is rounded. With `extra_turns` ≠ 0 the frame makes that
  /// many more revolutions. Throws DomainError for the angle to a Frenet frame.
  MinimalTwist(const PathAngle& rmf, StartAngle from, StartAngle to,
               const Integer& extra_turns = 0);
  MinimalTwist(const MinimalTwist&) = default;
  MinimalTwist& operator=(const MinimalTwist&) = default;
  ~MinimalTwist() = default;

  const StartAngle& from() const { return from_; }          ///< θ_i
  const StartAngle& to() const { return to_; }              ///< θ_f
  const Real& length() const { return whole_; }             ///< S
  const PathLength& arc_length() const { return length_; }  ///< s
  /// The twist of the reference frame, −θ_RMF(end).
  const Real& own_twist() const { return own_twist_; }
  const Real& nominal_twist() const { return nominal_; }  ///< T
  /// T_min, plus 2π·extra_turns; exact where it is 0.
  const Real& twist() const { return twist_; }
  /// ReducedAngle::half_turn_within of T_min.
  const std::optional<Rational>& half_turn_within() const { return half_turn_within_; }
  Real rate() const;                                ///< the turn per unit of length: Ω̄₁
  const PathAngle& rmf() const { return rmf_; }     ///< θ_RMF
  const Path& path() const { return rmf_.path(); }  ///< along which it is
  /// θ(end) = θ_f + 2π·this.
  const Integer& turns_at_end() const { return turns_at_end_; }
  /// (θ(end) − θ(0))/2π, where that is a whole number: decided exactly if both angles are known
  /// exactly.
  std::optional<Integer> whole_turns_of_theta() const;

  /// Is the place t = 1/2 of a single curve that half a turn maps to itself
  /// (is_turned_over_by_half_turn())? There both integrals have half of their values, so that θ is
  /// (θ_i + θ(end))/2, and some components of the frame may be exactly 0.
  bool is_middle(const Place& at) const;
  /// @{ θ there. At the start it is θ_i and at the end θ_f plus whole turns, exactly; where the
  /// twist is 0 it is exact where θ_RMF and θ_i are. At a t that is not on the path DomainError is
  /// thrown.
  Real value(const Place& at) const;
  Real value(const Rational& t) const;
  /// @}
  /// The same less as many whole turns as take θ_i to (−π, π]: f₂ and f₃ depend on that only.
  Real reduced_value(const Place& at) const { return value_less(turns_at_start_, at); }

 private:
  Real value_less(const Integer& turns, const Place& at) const;

  PathAngle rmf_;
  PathLength length_;
  Real whole_;  ///< S
  StartAngle from_;
  StartAngle to_;
  Real own_twist_;
  Real nominal_;
  Real twist_;
  std::optional<Rational> half_turn_within_;
  Integer turns_at_start_ = 0;  ///< in θ_i
  Integer turns_at_end_ = 0;
};

/// The minimal twist between these ends; a vector, and the LeastRotation, of `to` is one at the
/// end. Without `to` the path is closed, and the frame ends as it starts. Throws DomainError as
/// start_angle(), and where there is no `to` and the path is not closed.
PHRAME_API MinimalTwist minimal_twist(const PathAngle& rmf, const FrameStart& from,
                                      const std::optional<FrameStart>& to,
                                      const Integer& extra_turns = 0);

/// The frame of minimal twist at a place.
PHRAME_API Frame<Real> minimal_twist_frame(const MinimalTwist& twist, const Place& at);

}  // namespace phrame
