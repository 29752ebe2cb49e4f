#pragma once
#include <optional>

#include "phrame/ph/sweep/length_share.hpp"
#include "phrame/ph/sweep/sweep_form.hpp"

namespace phrame {

/// φ, the angle by which a profile turns against the rotation-minimizing frame, in doubles: evenly
/// over the whole length, and leg by leg.
class SweepTurn {
 public:
  /// Throws Undecided as LengthShare where it turns at all.
  SweepTurn(const SweepPath& path, const SweepForm& form);

  bool is_zero() const { return !share_; }  ///< does it not turn?
  /// At t ∈ [0, 1] of a segment.
  double angle(std::size_t segment, double t) const;
  double rate(std::size_t segment, double t) const;  ///< dφ/ds there
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
  std::optional<LengthShare> share_;
  std::vector<Leg> legs_;
  double error_ = 0;
};

}  // namespace phrame
