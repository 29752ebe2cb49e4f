#include "phrame/ph/along/arc_length.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "phrame/algebra/as_written.hpp"
#include "phrame/algebra/error.hpp"
#include "phrame/algebra/increasing.hpp"
#include "phrame/ph/curve/invariants.hpp"
#include "phrame/ph/curve/special_points.hpp"

// s′ = |f|σ ≥ 0 is a polynomial without a sign change, not 0, so that s is strictly increasing and
// s(t) = s has one solution. It is guessed in doubles and proved by an interval Newton step. That t
// is rational is decided by Gauss's lemma, without factors. At a cusp s′ = 0 and Newton's method
// fails: there the interval is bisected.

namespace phrame::inline v0 {

bool has_polynomial_length(const Curve& curve) {
  if (!curve.is_polynomial()) return false;
  const Signs signs = multiplier_signs(curve);
  return !(signs.positive && signs.negative);
}

Polynomial arc_length(const Curve& curve) {
  if (!curve.is_polynomial())
    throw DomainError("arc length: the curve is rational, its length is no polynomial");
  return antiderivative(curve.multiplier() * sigma(curve.preimage()));
}

std::optional<Rational> arc_length(const Curve& curve, const Rational& a, const Rational& b) {
  if (!curve.is_polynomial()) return std::nullopt;
  if (!odd(real_roots(curve.multiplier(), open_interval(a, b))).empty()) return std::nullopt;
  const Polynomial s = arc_length(curve);
  return Rational(abs(s(b) - s(a)));
}

ArcLength::ArcLength(const Curve& curve) : length_(phrame::arc_length(curve)) {
  const Signs signs = multiplier_signs(curve);
  if (signs.positive && signs.negative)
    throw DomainError("arc length: the multiplier changes sign on [0, 1]");
  if (signs.negative) length_ = -length_;
  total_ = length_(1);
  for (const Rational& c : length_.coefficients())
    scaled_.push_back(round_to_double(Rational(c / total_)));
  const auto shared = std::make_shared<IncreasingFunction>();
  shared->value = [s = length_](const RealBall& t, long bits) { return evaluate(s, t, bits); };
  shared->slope = [speed = differentiate(length_)](const RealBall& t, long bits) {
    return evaluate(speed, t, bits);
  };
  function_ = shared;
}

void ArcLength::require_on_curve(const Rational& s) const {
  if (s < 0 || s > total_)
    throw DomainError(fmt::format("arc length: {} is outside [0, {}], the length of the curve",
                                  as_written(s), as_written(total_)));
}

/// Newton's method kept in a bracket. Whatever overflows, the result is in [0, 1].
double ArcLength::guess(const Rational& s) const {
  const double y = round_to_double(Rational(s / total_));
  double low = 0;
  double high = 1;
  double t = y;
  for (int step = 0; step < 60; ++step) {
    double value = 0;
    double slope = 0;
    for (std::size_t k = scaled_.size(); k-- > 0;) {
      slope = slope * t + value;
      value = value * t + scaled_[k];
    }
    (value > y ? high : low) = t;
    double next = t - (value - y) / slope;
    if (!(next > low && next < high)) next = (low + high) / 2;
    if (std::abs(next - t) < 1e-14) return next;
    t = next;
  }
  return t;
}

Real ArcLength::parameter(const Rational& s) const {
  if (s > total_ && is_rounded(s, total_)) return Rational(1);
  require_on_curve(s);
  if (s == 0) return Rational(0);
  if (s == total_) return Rational(1);
  const Real t = preimage(function_, s, guess(s));
  if (const auto exact = rational_root(length_ - Polynomial{s}, 0, 1, t)) return *exact;
  return t;
}

RealAlgebraic ArcLength::algebraic_parameter(const Rational& s) const {
  const Real t = parameter(s);
  if (t.exact()) return *t.exact();
  const RealBall around = t.enclose(64);
  return real_root(length_ - Polynomial{s}, closed_interval(std::max(around.lower(), Rational(0)),
                                                            std::min(around.upper(), Rational(1))));
}

}  // namespace phrame
