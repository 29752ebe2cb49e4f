#pragma once
#include <memory>

#include "phrame/export.hpp"
#include "phrame/ph/along/feedrate.hpp"
#include "phrame/ph/along/path_length.hpp"

namespace phrame::inline v0 {

struct Antiderivative;

/// The number of whole k ≥ 0 with k·period < total. Throws DomainError for a period ≤ 0; Undecided
/// where the total cannot be told from a multiple of the period.
PHRAME_API Integer ticks_before(const Real& total, const Rational& period);

/// The sign of time − x. Throws Undecided where 4096 bits do not tell it; `what` names x in the
/// message.
PHRAME_API int compare_time(const Rational& time, const Real& x, const std::string& what);

/// Is it a time beyond the total that rounds to the same double? Then it is the end: is_rounded().
PHRAME_API bool is_rounded_total(const Rational& time, const Real& total);

/// The time T(t) = ∫ |r′|/V dt a motion with feedrate V takes from the start of a path to t,
/// strictly increasing, and its inverse: the interpolation integral of [Farouki 2008], in closed
/// form along PH curves. The arc length and the parameter that V may depend on are those of the
/// whole path; the curvature is that in its plane, whose unit normal has a positive last component
/// that is not 0. Not for concurrent use; to move one is to copy it.
class PHRAME_API TravelTime {
 public:
  /// With V of another kind than a rational function, or limits of the acceleration, as
  /// SpeedProfile: the motion is the fastest one under all of them, and T has no closed form.
  /// Throws DomainError where V is not positive and finite all along; and of the curvature where
  /// the path is in no plane, or the curvature undefined. Throws Undecided where that is not told.
  /// That of V(s) and V(t) is decided by algebra, and of V(κ) along PH curves with a rational unit
  /// normal; elsewhere by Taylor series in balls.
  TravelTime(const Path& path, const Feedrate& feedrate);
  TravelTime(const TravelTime&) = default;
  TravelTime& operator=(const TravelTime&) = default;
  ~TravelTime() = default;

  const PathLength& length() const;  ///< the arc length along the path
  /// The time along segment k up to a constant, with V(t) or V(κ); null where it has no closed
  /// form.
  const Antiderivative* closed_form(std::size_t k) const;

  /// T there, exact where it is seen to be rational.
  Real time(const Place& at) const;
  const Real& total() const;  ///< T at the end
  /// ticks_before() the end.
  Integer ticks(const Rational& period) const { return ticks_before(total(), period); }

  /// A point of the path and the arc length up to it.
  struct Point {
    Place at;                        ///< of the path
    Real arc_length;                 ///< from the start of the path to there
    std::optional<Real> speed = {};  ///< there, where V is no rational function or has limits
  };
  /// The point with T = time, at a joint that of the later segment. Exact and algebraic t are
  /// decided along PH curves where T has no logarithms and is rational up to the start of the
  /// segment, as with a constant speed. Else t is transcendental by Baker's theorem, but where the
  /// logarithms cancel; of such t those with denominators of up to 32 bits are recognised, and the
  /// correct rounding of others may be undecided. Requests in ascending order are the fastest: the
  /// last t is where the search for the next one starts. The end for a time of which
  /// is_rounded_total() is true. Throws DomainError for another time outside [0, total()],
  /// Undecided where that is not decided, or the segment.
  Point at_time(const Rational& time);
  /// The end of the path.
  Point end() const;

 private:
  struct State;

  void require_within(const Rational& time) const;
  std::size_t segment_at(const Rational& time) const;
  Point point_at(const Place& at) const { return {at, length().value(at)}; }

  std::shared_ptr<const State> state_;
  std::size_t last_segment_ = 0;
  double last_ = 0;  ///< the last t found on it: the guess for the next
};

}  // namespace phrame
