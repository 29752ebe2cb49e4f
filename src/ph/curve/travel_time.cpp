#include "phrame/ph/curve/travel_time.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "phrame/algebra/error.hpp"

// T is an antiderivative of a rational function. Without logarithms T = n/d, and the t with T(t) =
// τ is the one root on [0, 1] of n − τd (up to the constant of T), because d has no zero there and
// T − τ only one. With logarithms T(t) is, for algebraic t, transcendental or the logarithms cancel
// [Baker 1975]: a t with a rational T(t) is transcendental but for such coincidences. Either way T
// and T′ give interval Newton steps, whose result is proved whatever the first guess was.

namespace phrame {
namespace {

constexpr long limit = 4096;

std::string text(const Real& x) {
  return x.exact() ? abbreviated(to_string(*x.exact())) : to_string(x.enclose(64), 12);
}

/// Is time > x? Throws Undecided.
bool is_later(const Rational& time, const Real& x) {
  if (x.exact()) return time > *x.exact();
  for (long bits = 128; bits <= limit; bits *= 2) {
    const RealBall ball = x.enclose(bits);
    if (time < ball.lower()) return false;
    if (time > ball.upper()) return true;
  }
  throw Undecided(fmt::format("travel time: {} bits do not tell the time {} from the total, {}",
                              limit, abbreviated(to_string(time)), text(x)));
}

/// The simplest rational in the ball, where its denominator has up to 32 bits.
std::optional<Rational> simple_rational(const RealBall& ball) {
  const Rational simplest = simplest_between(ball.lower(), ball.upper());
  if (denominator(simplest) >> 32 != 0) return std::nullopt;
  return simplest;
}

}  // namespace

Real TimedPoint::value(const Polynomial& p) const {
  if (algebraic) return algebraic->value(p);
  if (p.is_constant()) return p.coefficient(0);
  return Real(
      [t = parameter, p](long bits) { return evaluate(p, t.enclose(bits + 16), bits + 16); });
}

TravelTime::TravelTime(const Curve& curve, const Feedrate& feedrate)
    : rate_(travel_time_rate(curve, feedrate)),
      antiderivative_(integrate(rate_)),
      evaluator_(antiderivative_),
      total_(evaluator_.value(0, 1)) {
  const auto shared = std::make_shared<IncreasingFunction>();
  shared->value = [evaluator = evaluator_](const RealBall& t, long bits) {
    return evaluator.difference(0, t.lower(), bits);
  };
  shared->slope = [rate = rate_](const RealBall& t, long bits) { return evaluate(rate, t, bits); };
  function_ = shared;
}

Integer TravelTime::ticks(const Rational& period) const {
  if (period <= 0)
    throw DomainError(
        fmt::format("travel time: the period {} is not positive", abbreviated(to_string(period))));
  if (total_.exact()) return Integer(-floor(-*total_.exact() / period));
  for (long bits = 128; bits <= limit; bits *= 2) {
    const RealBall ball = total_.enclose(bits);
    const Integer low = floor(ball.lower() / period);
    if (low == floor(ball.upper() / period)) return Integer(low + 1);
  }
  throw Undecided(fmt::format(
      "travel time: {} bits do not tell the total, {}, from a multiple of the period {}", limit,
      text(total_), abbreviated(to_string(period))));
}

void TravelTime::require_within(const Rational& time) const {
  if (time < 0 || is_later(time, total_))
    throw DomainError(fmt::format("travel time: the time {} is outside [0, {}]",
                                  abbreviated(to_string(time)), text(total_)));
}

TimedPoint TravelTime::at_time(const Rational& time) {
  require_within(time);
  const auto exactly = [](const RealAlgebraic& t) {
    return TimedPoint{to_real(t), AlgebraicPoint(t)};
  };
  if (time == 0) return exactly(Rational(0));
  if (total_.exact() == time) return exactly(Rational(1));
  const Real t = preimage(function_, time, last_);
  const RealBall around = t.enclose(72);
  last_ = approximate(around);
  if (antiderivative_.logs.empty()) {
    const RationalFunction T =
        RationalFunction(antiderivative_.polynomial) + antiderivative_.rational;
    const Polynomial equation = T.numerator() - (T(0) + time) * T.denominator();
    if (const auto exact = rational_root(equation, 0, 1, t)) return exactly(*exact);
    return exactly(real_root(equation, closed(std::max(around.lower(), Rational(0)),
                                              std::min(around.upper(), Rational(1)))));
  }
  if (const auto r = simple_rational(around);
      r && *r >= 0 && *r <= 1 && evaluator_.value(0, *r).exact() == time)
    return exactly(*r);
  return {t, std::nullopt};
}

}  // namespace phrame
