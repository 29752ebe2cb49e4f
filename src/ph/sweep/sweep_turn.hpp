#pragma once
#include <optional>

#include "phrame/ph/sweep/length_share.hpp"
#include "phrame/ph/sweep/sweep_form.hpp"

namespace phrame::inline v0 {

/// φ + ρ, the angle by which a profile turns against the rotation-minimizing frame, in doubles: φ
/// evenly over the whole length, and leg by leg, and the roll ρ by t.
class SweepTurn {
 public:
  /// Throws Undecided as LengthShare where it turns by the length.
  SweepTurn(const SweepPath& path, const SweepForm& form);

  bool is_zero() const { return !share_ && rolls_.empty(); }  ///< does it not turn?
  /// At t ∈ [0, 1] of a segment.
  double angle(std::size_t segment, double t) const;
  double rate(std::size_t segment, double t) const;       ///< dφ/ds there
  double roll_rate(std::size_t segment, double t) const;  ///< dρ/dt there
  /// A bound of |dⁿρ/dtⁿ|, n = 1 or 2, on a part of a segment.
  double roll_bound(std::size_t order, std::size_t segment, const RealBall& t) const;
  /// @{ Bounds of |dφ/ds| and |d²φ/ds²| on a segment.
  double rate_bound(std::size_t segment) const;
  double second_bound(std::size_t segment) const;
  /// @}
  double error() const { return error_; }  ///< a bound of what angle() is off

 private:
  struct Leg {
    SweepLeg form;
    std::size_t first;  ///< its first segment
    double before;      ///< φ at its start, but for what turns over the whole length
    double share;       ///< of the whole length that lies before it
    double length;
  };
  const Leg* leg_at(std::size_t segment) const;
  double share_of(const Leg& leg, std::size_t segment, double t) const;

  double even_;  ///< turn over the whole length
  /// The roll of each segment, or one for all, with its first two derivatives; none where it is 0.
  std::vector<std::array<Roll::Piece, 3>> rolls_;
  RealBall roll_of(std::size_t order, std::size_t segment, const RealBall& t) const;
  std::optional<LengthShare> share_;
  std::vector<Leg> legs_;
  double error_ = 0;
};

}  // namespace phrame
