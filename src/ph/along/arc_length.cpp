#include "phrame/ph/along/arc_length.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "phrame/algebra/as_written.hpp"
#include "phrame/algebra/error.hpp"
#include "phrame/ph/curve/invariants.hpp"
#include "phrame/ph/curve/special_points.hpp"

// s′ = |f|σ ≥ 0 is a polynomial without a sign change, not 0, so that s is strictly increasing and
// s(t) = s has one solution. It is guessed in doubles and proved by an interval Newton step. That t
// is rational is decided by Gauss's lemma, without factors. At a cusp s′ = 0 and Newton's method
// fails: there the interval is bisected.

namespace phrame {
namespace {

constexpr auto why_none = "arc length: the multiplier changes sign on [0, 1]";

bool is_one_way(const Signs& signs) { return !(signs.positive && signs.negative); }

}  // namespace

Polynomial arc_length(const Curve& curve) {
  return antiderivative(curve.multiplier() * sigma(curve.preimage()));
}

std::optional<Rational> arc_length(const Curve& curve, const Rational& a, const Rational& b) {
  if (!odd(real_roots(curve.multiplier(), open(a, b))).empty()) return std::nullopt;
  const Polynomial s = arc_length(curve);
  return Rational(abs(s(b) - s(a)));
}

ArcLength::ArcLength(const Curve& curve) : length_(phrame::arc_length(curve)) {
  const Signs signs = multiplier_signs(curve);
  if (!is_one_way(signs)) throw DomainError(why_none);
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
  return real_root(length_ - Polynomial{s}, closed(std::max(around.lower(), Rational(0)),
                                                   std::min(around.upper(), Rational(1))));
}

PathLength::PathLength(PhPath path) : path_(std::move(path)) {
  for (const Curve& curve : path_.segments()) {
    lengths_.emplace_back();
    if (!is_one_way(multiplier_signs(curve))) continue;
    lengths_.back().emplace(curve);
    if (before_.size() == lengths_.size())
      before_.push_back(before_.back() + lengths_.back()->total());
  }
}

/// On the first segments.
void PathLength::require_one_way(std::size_t segments) const {
  if (segments < before_.size()) return;
  if (path_.is_curve()) throw DomainError(why_none);
  throw DomainError(fmt::format("segment {}: {}", before_.size(), why_none));
}

const ArcLength& PathLength::segment(std::size_t k) const {
  if (!lengths_[k]) require_one_way(k + 1);
  return *lengths_[k];
}

const Rational& PathLength::before(std::size_t k) const {
  require_one_way(k);
  return before_[k];
}

Rational PathLength::value(const PathParameter& at) const {
  return before(at.segment) + segment(at.segment).polynomial()(at.t);
}

std::optional<Rational> PathLength::between(const PathParameter& a, const PathParameter& b) const {
  const auto& segments = path_.segments();
  if (a.segment == b.segment) return arc_length(segments[a.segment], a.t, b.t);
  std::optional<Rational> sum = arc_length(segments[a.segment], a.t, 1);
  const auto add = [&sum](const std::optional<Rational>& part) {
    sum = sum && part ? std::optional<Rational>(*sum + *part) : std::nullopt;
  };
  for (std::size_t k = a.segment + 1; k < b.segment; ++k)
    add(lengths_[k] ? std::optional(lengths_[k]->total()) : std::nullopt);
  add(arc_length(segments[b.segment], 0, b.t));
  return sum;
}

PathPoint PathLength::point(const Rational& s) const {
  if (s > total() && is_rounded(s, total())) return {path_.segments().size() - 1, RealAlgebraic(1)};
  if (s < 0 || s > total())
    throw DomainError(
        fmt::format("arc length: {} is outside [0, {}]", as_written(s), as_written(total())));
  const auto next = std::upper_bound(before_.begin(), before_.end() - 1, s);
  const auto k = static_cast<std::size_t>(next - before_.begin()) - 1;
  return {k, segment(k).algebraic_parameter(s - before_[k])};
}

}  // namespace phrame
