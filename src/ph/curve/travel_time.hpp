#pragma once
#include <memory>

#include "phrame/algebra/algebraic_point.hpp"
#include "phrame/algebra/increasing.hpp"
#include "phrame/integrate/evaluator.hpp"
#include "phrame/integrate/integrate.hpp"
#include "phrame/ph/curve/feedrate.hpp"

namespace phrame {

/// A point of a curve that is reached at a given time.
struct TimedPoint {
  Real parameter;  ///< t
  /// t again, where it is known to be algebraic. Else it is transcendental, if only because no
  /// logarithm cancelled by chance.
  std::optional<AlgebraicPoint> algebraic;

  /// p(t), exact where it is known to be rational.
  Real value(const Polynomial& p) const;
};

/// The time T(t) = ∫₀ᵗ |f|σ/V a motion with feedrate V takes from 0 to t ∈ [0, 1], strictly
/// increasing, and its inverse: the interpolation integral of [Farouki 2008], in closed form.
class TravelTime {
 public:
  /// Throws DomainError as travel_time_rate().
  TravelTime(const Curve& curve, const Feedrate& feedrate);

  const RationalFunction& rate() const { return rate_; }  ///< T′
  const Antiderivative& antiderivative() const { return antiderivative_; }

  /// T(t), exact where it is rational.
  Real time(const Rational& t) const { return evaluator_.value(0, t); }

  const Real& total() const { return total_; }  ///< T(1)
  /// How many whole k ≥ 0 have k·period < T(1). Throws DomainError for a period ≤ 0, Undecided
  /// where T(1) cannot be told from a multiple of the period.
  Integer ticks(const Rational& period) const;

  /// The point with T = time. Exact and algebraic t are decided where T has no logarithms. Else t
  /// is transcendental by Baker's theorem, but where the logarithms cancel; of such t those with
  /// denominators of up to 32 bits are recognised, and the correct rounding of others may be
  /// undecided. Requests in ascending order are the fastest: the last t is where the search for the
  /// next one starts. Throws DomainError for a time outside [0, T(1)], Undecided where that is not
  /// decided.
  TimedPoint at_time(const Rational& time);

 private:
  void require_within(const Rational& time) const;

  RationalFunction rate_;
  Antiderivative antiderivative_;
  Evaluator evaluator_;
  std::shared_ptr<const IncreasingFunction> function_;
  Real total_;
  double last_ = 0;  ///< the last t found: the guess for the next
};

}  // namespace phrame
