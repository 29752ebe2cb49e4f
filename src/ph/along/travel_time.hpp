#pragma once
#include <memory>

#include "phrame/algebra/algebraic_point.hpp"
#include "phrame/algebra/increasing.hpp"
#include "phrame/integrate/evaluator.hpp"
#include "phrame/integrate/integral_sum.hpp"
#include "phrame/integrate/integrate.hpp"
#include "phrame/ph/along/feedrate.hpp"
#include "phrame/ph/along/path_length.hpp"
#include "phrame/ph/curve/ph_path.hpp"

namespace phrame {

/// A point of a path that is reached at a given time.
struct TimedPoint {
  std::size_t segment;  ///< of the path
  Real parameter;       ///< t, on that segment
  /// t again, where it is known to be algebraic. Else it is transcendental, if only because no
  /// logarithm cancelled by chance.
  std::optional<AlgebraicPoint> algebraic;

  /// p(t), exact where it is known to be rational.
  Real value(const Polynomial& p) const;
};

/// How many whole k ≥ 0 have k·period < total. Throws DomainError for a period ≤ 0, Undecided where
/// the total cannot be told from a multiple of the period.
Integer ticks_before(const Real& total, const Rational& period);

/// The sign of time − x. Throws Undecided where 4096 bits do not tell; `what` is what x is.
int compare_time(const Rational& time, const Real& x, const std::string& what);

/// Is it a time beyond the total that rounds to the same double? Then it is the end: is_rounded().
bool is_rounded_total(const Rational& time, const Real& total);

/// The time T(t) = ∫₀ᵗ |f|σ/V a motion with feedrate V takes from the start of a path to t,
/// strictly increasing, and its inverse: the interpolation integral of [Farouki 2008], in closed
/// form. The arc length and the parameter that V may depend on are those of the whole path; so is
/// the plane that the curvature belongs to. Not for concurrent use.
class TravelTime {
 public:
  /// Throws DomainError as travel_time_rate(), and where the curvature is asked for and the
  /// segments are not in one plane.
  TravelTime(const PhPath& path, const Feedrate& feedrate);

  const PathLength& length() const { return length_; }  ///< the arc length along the path
  /// |f|σ/V, dT/dt on this segment.
  const RationalFunction& rate(std::size_t segment = 0) const { return segments_[segment].rate; }
  /// Of that rate, so that differences of it are times.
  const Antiderivative& antiderivative(std::size_t segment = 0) const {
    return segments_[segment].antiderivative;
  }

  /// T(t), exact where it is seen to be rational. Throws DomainError for t outside [0, end].
  Real time(const Rational& t) const;

  const Real& total() const { return starts_.back(); }  ///< T(end)
  /// ticks_before() the end.
  Integer ticks(const Rational& period) const { return ticks_before(total(), period); }

  /// The point with T = time, at a joint that of the later segment. Exact and algebraic t are
  /// decided where T has no logarithms, and on a spline where T is rational up to the start of the
  /// segment. Else t is transcendental by Baker's theorem, but where the logarithms cancel; of such
  /// t those with denominators of up to 32 bits are recognised, and the correct rounding of others
  /// may be undecided. Requests in ascending order are the fastest: the last t is where the search
  /// for the next one starts. The end for a time of which is_rounded_total() is true. Throws
  /// DomainError for another time outside [0, T(end)], Undecided where that is not decided, or the
  /// segment.
  TimedPoint at_time(const Rational& time);

 private:
  struct Segment {
    RationalFunction rate;
    Antiderivative antiderivative;
    Evaluator evaluator;  ///< of it
  };

  void require_within(const Rational& time) const;
  std::size_t segment_at(const Rational& time) const;
  void go_to(std::size_t segment);
  KnownIntegral integral(const PathParameter& at) const;
  Real time(const PathParameter& at) const;

  PhPath path_;
  PathLength length_;
  std::vector<Segment> segments_;
  std::vector<Real> starts_;  ///< T at their starts and at the end
  std::size_t last_segment_ = 0;
  std::shared_ptr<const IncreasingFunction> function_;  ///< along that segment
  double last_ = 0;  ///< the last t found: the guess for the next
};

}  // namespace phrame
