#include "phrame/ph/along/travel_time.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "phrame/algebra/as_written.hpp"
#include "phrame/algebra/error.hpp"
#include "phrame/ph/curve/shape.hpp"

// T is an antiderivative of a rational function. Without logarithms T = n/d, and the t with T(t) =
// τ is the one root on [0, 1] of n − τd (up to the constant of T), because d has no zero there and
// T − τ only one. With logarithms T(t) is, for algebraic t, transcendental or the logarithms cancel
// [Baker 1975]: a t with a rational T(t) is transcendental but for such coincidences. Either way T
// and T′ give interval Newton steps, whose result is proved whatever the first guess was.
//
// On a segment of a path the time sought is τ − T(start), T counted from its start. Where T(start)
// is irrational, τ is sought among the values of T(start) + T, a function that increases likewise.
// T(start) is then transcendental, and so is t, but for logarithms of different segments that
// cancel.

namespace phrame {
namespace {

constexpr long limit = 4096;

std::string text(const Real& x) {
  return x.exact() ? as_written(*x.exact()) : to_string(x.enclose(64), 12);
}

KnownIntegral known(const Rational& x) { return {{x, ExactValue{x, 0, {}, {}}}}; }

}  // namespace

Integer ticks_before(const Real& total, const Rational& period) {
  if (period <= 0)
    throw DomainError(
        fmt::format("travel time: the period {} is not positive", as_written(period)));
  if (total.exact()) return Integer(-floor(-*total.exact() / period));
  for (long bits = 128; bits <= limit; bits *= 2) {
    const RealBall ball = total.enclose(bits);
    const Integer low = floor(ball.lower() / period);
    if (low == floor(ball.upper() / period)) return Integer(low + 1);
  }
  throw Undecided(fmt::format(
      "travel time: {} bits do not tell the total, {}, from a multiple of the period {}", limit,
      text(total), as_written(period)));
}

int compare_time(const Rational& time, const Real& x, const std::string& what) {
  if (x.exact()) return time < *x.exact() ? -1 : time > *x.exact() ? 1 : 0;
  for (long bits = 128; bits <= limit; bits *= 2) {
    const RealBall ball = x.enclose(bits);
    if (time < ball.lower()) return -1;
    if (time > ball.upper()) return 1;
  }
  throw Undecided(fmt::format("travel time: {} bits do not tell the time {} from {}, {}", limit,
                              as_written(time), what, text(x)));
}

bool is_rounded_total(const Rational& time, const Real& total) {
  return time > 0 && time >= total.enclose(128).lower() &&
         compare_time(time, total, "the total") > 0 && is_rounded(time, total);
}

Real TimedPoint::value(const Polynomial& p) const {
  if (algebraic) return algebraic->value(p);
  if (p.is_constant()) return p.coefficient(0);
  return Real(
      [t = parameter, p](long bits) { return evaluate(p, t.enclose(bits + 16), bits + 16); });
}

TravelTime::TravelTime(const PhPath& path, const Feedrate& feedrate)
    : path_(path), length_(Path(path)), starts_{Rational(0)} {
  if (feedrate.of == Feedrate::Of::curvature && !path.is_curve() && !plane_normal(path))
    throw DomainError("signed curvature: the spline is not plane");
  std::vector<KnownIntegral> since_rational;
  for (std::size_t k = 0; k < path.segments().size(); ++k) {
    if (!length_.closed_form(k))
      throw DomainError(fmt::format("{}arc length: the multiplier changes sign on [0, 1]",
                                    path.is_curve() ? "" : fmt::format("segment {}: ", k + 1)));
    const SegmentStart start{Rational(static_cast<long>(k)), *length_.before(k).exact()};
    const RationalFunction rate = travel_time_rate(path.segments()[k], feedrate, start);
    const Antiderivative T = integrate(rate);
    segments_.push_back({rate, T, Evaluator(T, rate)});
    since_rational.push_back(integral({k, 1}));
    starts_.push_back(remembered(sum_of_integrals(since_rational).value));
    if (const auto exact = starts_.back().exact()) since_rational = std::vector{known(*exact)};
  }
  go_to(0);
}

/// The time from the start of the segment.
KnownIntegral TravelTime::integral(const PathParameter& at) const {
  const Segment& here = segments_[at.segment];
  const Real value = here.evaluator.value(0, at.t);
  if (value.exact()) return known(*value.exact());
  return {{remembered(value), std::nullopt}, {{here.rate, here.antiderivative, 0, at.t}}};
}

Real TravelTime::time(const PathParameter& at) const {
  const Real& start = starts_[at.segment];
  if (start.exact()) return segments_[at.segment].evaluator.value(0, at.t) + start;
  std::vector<KnownIntegral> integrals;
  for (std::size_t k = 0; k < at.segment; ++k) integrals.push_back(integral({k, 1}));
  integrals.push_back(integral(at));
  return sum_of_integrals(integrals).value;
}

Real TravelTime::time(const Rational& t) const { return time(locate_inside(path_, t)); }

void TravelTime::require_within(const Rational& time) const {
  if (time < 0 || compare_time(time, total(), "the total") > 0)
    throw DomainError(fmt::format("travel time: the time {} is outside [0, {}]", as_written(time),
                                  text(total())));
}

/// The last one that starts at that time or before.
std::size_t TravelTime::segment_at(const Rational& time) const {
  std::size_t k = last_segment_;
  const auto starts_later = [&](std::size_t segment) {
    return compare_time(time, starts_[segment], fmt::format("that at t = {}", segment)) < 0;
  };
  while (k > 0 && starts_later(k)) --k;
  while (k + 1 < segments_.size() && !starts_later(k + 1)) ++k;
  return k;
}

void TravelTime::go_to(std::size_t segment) {
  if (function_ && segment == last_segment_) return;
  const Segment& here = segments_[segment];
  const Real& start = starts_[segment];
  const auto along = std::make_shared<IncreasingFunction>();
  along->value = [evaluator = here.evaluator](const RealBall& t, long bits) {
    return evaluator.difference(0, t.lower(), bits);
  };
  if (!start.exact())
    along->value = [T = along->value, start](const RealBall& t, long bits) {
      return add(start.enclose(bits), T(t, bits), bits);
    };
  along->slope = [rate = here.rate](const RealBall& t, long bits) {
    return evaluate(rate, t, bits);
  };
  function_ = along;
  last_segment_ = segment;
  last_ = 0;
}

TimedPoint TravelTime::at_time(const Rational& time) {
  const bool is_end = is_rounded_total(time, total());
  if (!is_end) require_within(time);
  const std::size_t k = is_end ? segments_.size() - 1 : segment_at(time);
  const auto exactly = [k](const RealAlgebraic& t) {
    return TimedPoint{k, to_real(t), AlgebraicPoint(t)};
  };
  if (is_end) return exactly(Rational(1));
  const auto& start = starts_[k].exact();
  if (start == time) return exactly(Rational(0));
  if (starts_[k + 1].exact() == time) return exactly(Rational(1));
  go_to(k);
  const Rational sought = start ? Rational(time - *start) : time;
  const Real t = preimage(function_, sought, last_);
  const RealBall around = t.enclose(72);
  last_ = approximate(around);
  if (const Antiderivative& F = antiderivative(k); start && F.logs.empty()) {
    const RationalFunction T = RationalFunction(F.polynomial) + F.rational;
    const Polynomial equation = T.numerator() - (T(0) + sought) * T.denominator();
    if (const auto exact = rational_root(equation, 0, 1, t)) return exactly(*exact);
    return exactly(real_root(equation, closed(std::max(around.lower(), Rational(0)),
                                              std::min(around.upper(), Rational(1)))));
  }
  const Real known = recognized(t, [&](const Rational& r) {
    return this->time(PathParameter{k, r}).exact() == time;
  });
  if (known.exact()) return exactly(*known.exact());
  return {k, t, std::nullopt};
}

}  // namespace phrame
