#include "phrame/ph/along/travel_time.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "phrame/algebra/algebraic_image.hpp"
#include "phrame/algebra/as_written.hpp"
#include "phrame/algebra/error.hpp"
#include "phrame/algebra/increasing.hpp"
#include "phrame/integrate/integral_sum.hpp"
#include "phrame/ph/along/segment_time.hpp"
#include "phrame/ph/along/speed_profile.hpp"
#include "phrame/ph/along/time_of_length.hpp"
#include "phrame/ph/along/up_vector.hpp"

// With V(s) the time is G(s(t)), G(s) = ∫ du/V(u) up to s in closed form. With V(t) and V(κ) it is
// found segment by segment.
//
// T is an antiderivative of a rational function of t along PH curves, and G one of s, which is a
// polynomial s(t) there. Without logarithms T = n/d, and the t with T(t) = τ is the one root on [0,
// 1] of n − τd (up to the constant of T), because d has no zero there and T − τ only one. With
// logarithms T(t) is, for algebraic t, transcendental or the logarithms cancel [Baker 1975]: a t
// with a rational T(t) is transcendental but for such coincidences. Either way T and T′ give
// interval Newton steps, whose result is proved whatever the first guess was.
//
// Where T is irrational at the start of a segment, it is transcendental there, and so is t, but for
// logarithms of different segments that cancel.

namespace phrame::inline v0 {
namespace {

constexpr long limit = 4096;

std::string text(const Real& x) {
  return x.exact() ? as_written(*x.exact()) : to_string(x.enclose(64), 12);
}

KnownIntegral known(const Rational& x) { return {{x, exact_value(x)}}; }

/// "s = 5"; along PH curves with a polynomial length "t = 3/2", a root of p(s(t)).
std::string place_of_length(const PathLength& length, std::size_t count, const RealAlgebraic& s) {
  std::size_t at = 0;
  for (std::size_t k = 0; k < count; ++k) {
    if (!length.closed_form(k)) return place_text("s", s);
    if (compare(s, *length.before(k).exact()) >= 0) at = k;
  }
  const Polynomial along =
      length.closed_form(at)->polynomial() + Polynomial{*length.before(at).exact()};
  const RealAlgebraic t =
      real_roots(compose(s.polynomial(), along), closed_interval(0, 1)).front().at;
  return place_text("t", affine(t, 1, Rational(static_cast<long>(at))));
}

/// With the last component that is not 0 positive.
Vector<Rational> upward(const Vector<Rational>& n) {
  const Rational& last = n[2] != 0 ? n[2] : n[1] != 0 ? n[1] : n[0];
  return last > 0 ? n : Vector<Rational>{-n[0], -n[1], -n[2]};
}

Vector<Rational> normal_of(const Path& path) {
  if (const auto found = plane_normal(path)) return upward(*found);
  if (!path.is_ph())
    throw DomainError("feedrate: the signed curvature is that of a path in one plane");
  throw DomainError(path.segments().size() == 1 ? "signed curvature: the curve is not plane"
                                                : "signed curvature: the spline is not plane");
}

/// Does V depend on the signed curvature?
bool is_of_curvature(const Feedrate& feedrate) {
  constexpr auto curvature = Feedrate::Of::curvature;
  if (feedrate.pieces.empty()) return feedrate.of == curvature && !constant(feedrate.speed);
  for (const Feedrate::Piece& piece : feedrate.pieces)
    for (const auto& group : piece.least_of)
      for (const Feedrate::Function& f : group)
        if (f.of == curvature && !is_constant(f.speed)) return true;
  return false;
}

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

struct PHRAME_INSIDE TravelTime::State {
  Path path;
  PathLength length;
  std::optional<SpeedProfile> profile{};  ///< with V of another kind
  std::optional<Rational> constant_speed{};
  std::optional<TimeOfLength> of_length{};  ///< with V(s)
  std::vector<SegmentTime> segments{};      ///< with V(t) and V(κ)
  bool are_closed = false;                  ///< do all of these have closed forms?
  std::vector<Real> starts{Rational(0)};    ///< T where segments start, and at the end

  State(const Path& along, const Feedrate& feedrate);

  void set_speed(const Feedrate& feedrate);
  void add_segments(const Feedrate& feedrate);
  void add_starts();
  KnownIntegral integral(std::size_t k, const Rational& t) const;
  Real time(const Place& at) const;
  RealBall enclose(std::size_t k, const Rational& t, long bits) const;
  RealBall rate(std::size_t k, const RealBall& t, long bits) const;
  std::optional<Polynomial> equation(std::size_t k, const Rational& time) const;
};

TravelTime::State::State(const Path& along, const Feedrate& feedrate) : path(along), length(along) {
  if (!feedrate.is_rational()) {
    profile.emplace(path, length, feedrate,
                    is_of_curvature(feedrate) ? std::optional(normal_of(path)) : std::nullopt);
    starts.push_back(cached(profile->total()));
    return;
  }
  set_speed(feedrate);
  add_starts();
}

void TravelTime::State::set_speed(const Feedrate& feedrate) {
  const RationalFunction& speed = feedrate.speed;
  constant_speed = constant(speed);
  if (feedrate.of == Feedrate::Of::curvature && !constant_speed && is_straight(path))
    constant_speed = speed_without_curvature(speed);
  if (constant_speed)
    return require_positive(RationalFunction(Polynomial{*constant_speed}), Rational(0), {});
  if (feedrate.of != Feedrate::Of::arc_length) return add_segments(feedrate);
  require_positive(speed, length.total(), [this](const RealAlgebraic& s) {
    return place_of_length(length, path.segments().size(), s);
  });
  of_length.emplace(speed);
}

void TravelTime::State::add_segments(const Feedrate& feedrate) {
  const bool is_by_parameter = feedrate.of == Feedrate::Of::parameter;
  const Vector<Rational> normal = is_by_parameter ? Vector<Rational>{} : normal_of(path);
  for (const Segment& segment : path.segments()) {
    const Rational start(static_cast<long>(segments.size()));
    segments.push_back(is_by_parameter ? time_by_parameter(segment, feedrate.speed, start)
                                       : time_by_curvature(segment, feedrate.speed, normal, start));
  }
}

/// From the last rational one on, what is irrational of different segments may cancel where all
/// have closed forms.
void TravelTime::State::add_starts() {
  are_closed = std::all_of(segments.begin(), segments.end(),
                           [](const SegmentTime& segment) { return segment.closed_form(); });
  std::vector<KnownIntegral> since_rational;
  for (std::size_t k = 0; k < path.segments().size(); ++k) {
    if (segments.empty() || !are_closed) {
      starts.push_back(cached(time({k, Rational(1)})));
      continue;
    }
    since_rational.push_back(integral(k, 1));
    starts.push_back(cached(sum_of_integrals(since_rational).value));
    if (const auto exact = starts.back().exact()) since_rational = std::vector{known(*exact)};
  }
}

/// The time from the start of the segment, in closed form.
KnownIntegral TravelTime::State::integral(std::size_t k, const Rational& t) const {
  const Real value = segments[k].value(t);
  if (value.exact()) return known(*value.exact());
  const auto& closed = *segments[k].closed_form();
  return {{cached(value), std::nullopt}, {{closed.rate, closed.antiderivative, 0, t}}};
}

Real TravelTime::State::time(const Place& at) const {
  if (profile) return profile->time(at);
  if (segments.empty()) {
    const Real s = length.value(at);
    return of_length ? of_length->value(s) : Rational(1 / *constant_speed) * s;
  }
  const Real& start = starts[at.segment];
  if (start.exact() || !at.t.exact() || !are_closed)
    return segments[at.segment].value(at.t) + start;
  std::vector<KnownIntegral> integrals;
  for (std::size_t k = 0; k < at.segment; ++k) integrals.push_back(integral(k, 1));
  integrals.push_back(integral(at.segment, *at.t.exact()));
  return sum_of_integrals(integrals).value;
}

RealBall TravelTime::State::enclose(std::size_t k, const Rational& t, long bits) const {
  if (of_length) return of_length->enclose(length.enclose({k, t}, bits + 8), bits);
  return add(starts[k].enclose(bits), segments[k].enclose(t, bits), bits);
}

RealBall TravelTime::State::rate(std::size_t k, const RealBall& t, long bits) const {
  if (!of_length) return segments[k].rate(t, bits);
  const RealBall s = length.enclose({k, Real([t](long) { return t; })}, bits);
  return multiply(length.rate(k, t, bits), of_length->rate(s, bits), bits);
}

/// Of which the t with T(t) = time is the one root on [0, 1], where there is a polynomial.
std::optional<Polynomial> TravelTime::State::equation(std::size_t k, const Rational& time) const {
  const auto without_logs = [](const Antiderivative& F) {
    return F.logs.empty() ? std::optional(RationalFunction(F.polynomial) + F.rational)
                          : std::nullopt;
  };
  const auto root_of = [](const RationalFunction& T, const Rational& value) {
    return T.numerator() - (T(0) + value) * T.denominator();
  };
  if (!segments.empty()) {
    const auto* closed = segments[k].closed_form();
    if (closed == nullptr || !starts[k].exact()) return std::nullopt;
    const auto T = without_logs(closed->antiderivative);
    return T ? std::optional(root_of(*T, time - *starts[k].exact())) : std::nullopt;
  }
  const auto s = length.closed_form(k);
  const auto start = length.before(k).exact();
  const auto G = without_logs(of_length->antiderivative());
  if (!s || !start || !G) return std::nullopt;
  return compose(root_of(*G, time), s->polynomial() + Polynomial{*start});
}

TravelTime::TravelTime(const Path& path, const Feedrate& feedrate)
    : state_(std::make_shared<const State>(path, feedrate)) {}

const PathLength& TravelTime::length() const { return state_->length; }
const Antiderivative* TravelTime::closed_form(std::size_t k) const {
  if (state_->profile) return nullptr;
  const auto* form = state_->segments.at(k).closed_form();
  return form == nullptr ? nullptr : &form->antiderivative;
}
const Real& TravelTime::total() const { return state_->starts.back(); }
Real TravelTime::time(const Place& at) const { return state_->time(at); }

TravelTime::Point TravelTime::end() const {
  const Place last(state_->path.segments().size() - 1, Rational(1));
  if (!state_->profile) return {last, length().total()};
  return {last, length().total(), square_root_of(state_->profile->pieces().back().w1)};
}

void TravelTime::require_within(const Rational& time) const {
  if (time < 0 || compare_time(time, total(), "the total") > 0)
    throw DomainError(fmt::format("travel time: the time {} is outside [0, {}]", as_written(time),
                                  text(total())));
}

/// The last one that starts at that time or before.
std::size_t TravelTime::segment_at(const Rational& time) const {
  std::size_t k = last_segment_;
  const auto starts_later = [&](std::size_t segment) {
    return compare_time(time, state_->starts[segment], fmt::format("that at t = {}", segment)) < 0;
  };
  while (k > 0 && starts_later(k)) --k;
  while (k + 1 < state_->path.segments().size() && !starts_later(k + 1)) ++k;
  return k;
}

TravelTime::Point TravelTime::at_time(const Rational& time) {
  if (is_rounded_total(time, total())) return end();
  require_within(time);
  if (state_->profile) {
    const auto [at, s] = state_->profile->at_time(time);
    return {at, s, state_->profile->speed(time, at)};
  }
  if (state_->constant_speed) {
    const Rational s = *state_->constant_speed * time;
    return {length().point(s), s};
  }
  const std::size_t k = segment_at(time);
  if (state_->starts[k].exact() == time) return point_at({k, Rational(0)});
  if (state_->starts[k + 1].exact() == time) return point_at({k, Rational(1)});
  if (k != last_segment_) last_ = 0;
  last_segment_ = k;
  const auto T = std::make_shared<const IncreasingFunction>(IncreasingFunction{
      [state = state_, k](const RealBall& t, long bits) {
        return state->enclose(k, t.midpoint(), bits);
      },
      [state = state_, k](const RealBall& t, long bits) { return state->rate(k, t, bits); }});
  const Real t = preimage(T, time, guess_preimage(*T, time, last_));
  const RealBall around = t.enclose(72);
  last_ = approximate(around);
  if (const auto p = state_->equation(k, time)) {
    if (const auto exact = rational_root(*p, 0, 1, t)) return point_at({k, *exact});
    return point_at({k, real_root(*p, closed_interval(std::max(around.lower(), Rational(0)),
                                                      std::min(around.upper(), Rational(1))))});
  }
  return point_at({k, recognized(t, [&](const Rational& r) {
                     return this->time({k, r}).exact() == time;
                   })});
}

}  // namespace phrame
