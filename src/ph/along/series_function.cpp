#include "phrame/ph/along/series_function.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <mutex>

#include "phrame/algebra/ball_order.hpp"
#include "phrame/algebra/error.hpp"
#include "phrame/algebra/increasing.hpp"
#include "phrame/ph/curve/real_vector.hpp"

// On a part with the middle m, f is f(m) + (t − m)·f′ somewhere on it; where f′ has no zero there,
// the signs at the ends tell whether f has one.

namespace phrame::inline v0 {
namespace {

constexpr int most_halvings = 40;

/// How many bits of f(t) are lost, as where the terms of a polynomial cancel: as if half of 1024
/// bits were, where it is 0 or nearly so.
long lost_bits(const SeriesFunction& f, const Rational& t) {
  for (long bits = 64; bits <= 1024; bits *= 2) {
    const long known = f(RealBall(t, bits), 1, bits).coefficient(0).accuracy_bits();
    if (known >= bits / 2) return std::max(0L, bits - known);
  }
  return 512;
}

/// No value where it is not told.
std::optional<int> known_sign(const SeriesFunction& f, const Rational& t) {
  for (long bits = 64; bits <= 1024; bits *= 2) {
    const RealBall value = f(RealBall(t, bits), 1, bits).coefficient(0);
    if (const int found = sign(value); found != 0 || value.is_zero()) return found;
  }
  return std::nullopt;
}

/// The zero of f on the part, on which it is monotone.
Real zero_of(const SeriesFunction& f, const Rational& lower, const Rational& upper, int sign) {
  const auto coefficient = [f, sign](const RealBall& t, long k, long bits) {
    const RealBall c = f(t, k + 1, bits).coefficient(k);
    return sign > 0 ? c : subtract({}, c, bits);
  };
  return zero_between(
      lower, upper,
      {[coefficient](const RealBall& t, long bits) { return coefficient(t, 0, bits); },
       [coefficient](const RealBall& t, long bits) { return coefficient(t, 1, bits); }});
}

class ZeroSearch {
 public:
  ZeroSearch(const SeriesFunction& f, const std::string& what) : f_(f), what_(what) {}

  struct End {
    Rational at;
    int sign;
  };
  void search(const End& lower, const End& upper, int halvings);
  std::vector<Real> found() && { return std::move(found_); }

 private:
  End cut(const Rational& lower, const Rational& upper) const;

  const SeriesFunction& f_;
  const std::string& what_;
  std::vector<Real> found_;
};

void ZeroSearch::search(const End& lower, const End& upper, int halvings) {
  const Rational middle = (lower.at + upper.at) / 2;
  const long bits = 64 + 2 * lost_bits(f_, middle);
  const RealBall all = hull(lower.at, upper.at, bits);
  const RealBall slope = f_(all, 2, bits).coefficient(1);
  if (slope.is_finite()) {
    const RealBall value = f_(RealBall(middle, bits), 1, bits).coefficient(0);
    const RealBall step = subtract(all, RealBall(middle, bits), bits);
    if (sign(add_product(value, slope, step, bits)) != 0) return;
    if (const int side = sign(slope); side != 0) {
      if (lower.sign * upper.sign < 0) found_.push_back(zero_of(f_, lower.at, upper.at, side));
      return;
    }
  }
  if (halvings == most_halvings)
    throw Undecided(fmt::format("{} near t = {:.9g}", what_, static_cast<double>(middle)));
  const End between = cut(lower.at, upper.at);
  search(lower, between, halvings + 1);
  search(between, upper, halvings + 1);
}

/// Near the middle, but not at a zero.
ZeroSearch::End ZeroSearch::cut(const Rational& lower, const Rational& upper) const {
  for (const long share : {31, 34, 27, 38}) {
    const Rational at = lower + Rational(share, 64) * (upper - lower);
    if (const auto found = known_sign(f_, at); found && *found != 0) return {at, *found};
  }
  throw Undecided(fmt::format("{} near t = {:.9g}", what_, static_cast<double>(lower)));
}

}  // namespace

int sign_at(const SeriesFunction& f, const Rational& t) {
  if (const auto found = known_sign(f, t)) return *found;
  throw Undecided(
      fmt::format("feedrate: a speed is undefined, or two limits of it are equal to 1024 "
                  "bits, at t = {:.9g}",
                  static_cast<double>(t)));
}

std::vector<Real> sign_changes(const SeriesFunction& f, const Rational& lower,
                               const Rational& upper, const std::string& what) {
  ZeroSearch zeros(f, what);
  zeros.search({lower, sign_at(f, lower)}, {upper, sign_at(f, upper)}, 0);
  return std::move(zeros).found();
}

int order(const Real& a, const Real& b) {
  const Real difference = a + -b;
  const int found = sign_of(difference);
  if (found == 0 && !difference.exact())
    throw Undecided("feedrate: two places where the motion changes are not told apart");
  return found;
}

Rational below(const Real& t) {
  return t.exact() ? *t.exact() : std::max(Rational(0), t.enclose(96).lower());
}
Rational above(const Real& t) {
  return t.exact() ? *t.exact() : std::min(Rational(1), t.enclose(96).upper());
}

std::vector<Real> sign_changes(const SeriesFunction& f, const Real& a, const Real& b,
                               const std::string& what) {
  std::vector<Real> found = sign_changes(f, below(a), above(b), what);
  std::erase_if(found, [&](const Real& t) {
    return (!a.exact() && order(t, a) <= 0) || (!b.exact() && order(t, b) >= 0);
  });
  return found;
}

struct SeriesIntegral::Part {
  Rational lower;
  Rational upper;
  BallPolynomial integral;  ///< from `lower`, in z = t − middle
  RealBall rest;            ///< |∫ f − integral| is at most its greatest number
  RealBall before;          ///< the integral from the start to `lower`
};

struct SeriesIntegral::State {
  SeriesFunction f;
  Rational lower;
  Rational upper;
  std::mutex lock{};
  std::map<long, std::vector<Part>> known{};  ///< by bits: those of more take longer to evaluate

  State(SeriesFunction of, Rational from, Rational to)
      : f(std::move(of)), lower(std::move(from)), upper(std::move(to)) {}

  const std::vector<Part>& with(long bits);
  std::vector<Part> find_parts(long bits) const;
  bool add(std::vector<Part>& parts, const Rational& from, const Rational& to, long bits) const;
};

const std::vector<SeriesIntegral::Part>& SeriesIntegral::State::with(long bits) {
  long enough = 192;  // what rounding to doubles asks for, of all that is
  while (enough < bits) enough *= 2;
  const std::lock_guard locked(lock);
  const auto at = known.find(enough);
  return at != known.end() ? at->second : known.emplace(enough, find_parts(enough)).first->second;
}

std::vector<SeriesIntegral::Part> SeriesIntegral::State::find_parts(long bits) const {
  std::vector<Part> found;
  Rational step = upper - lower;
  for (Rational at = lower; at < upper;) {
    step = std::min(step, Rational(upper - at));
    while (!add(found, at, at + step, bits)) step /= 2;
    at += step;
    step = step * Rational(3, 2);
  }
  return found;
}

/// The next part, where it is not too long.
bool SeriesIntegral::State::add(std::vector<Part>& parts, const Rational& from, const Rational& to,
                                long bits) const {
  const Rational middle = (from + to) / 2;
  const long more = 2 * lost_bits(f, middle) + 32;
  const long working = bits + more;
  const long length = bits / 4 + 6;
  const RealBall half((to - from) / 2, 64);
  const RealBall next = f(hull(from, to, 64 + more), length + 1, 64 + more).coefficient(length);
  const RealBall rest =
      times_power_of_two(multiply(absolute(next), pow(half, length + 1, 64), 64), 1);
  if (!rest.is_finite() || exponent_above(rest) > -bits) {
    if (to - from < Rational(1, Integer(1) << 60))
      throw Undecided(fmt::format("feedrate: the time is not seen to be finite near t = {:.9g}",
                                  static_cast<double>(middle)));
    return false;
  }
  BallPolynomial integral = antiderivative(f(RealBall(middle, working), length, working), working);
  const RealBall start = evaluate(integral, RealBall(from - middle, working), working);
  integral = with_constant(integral, subtract({}, start, working));
  RealBall before;
  if (!parts.empty()) {
    const Part& last = parts.back();
    const RealBall step((last.upper - last.lower) / 2, working);
    before = phrame::add(last.before, widened(evaluate(last.integral, step, working), last.rest),
                         working);
  }
  parts.push_back({from, to, std::move(integral), rest, before});
  return true;
}

SeriesIntegral::SeriesIntegral(SeriesFunction f, const Rational& lower, const Rational& upper)
    : state_(std::make_shared<State>(std::move(f), lower, upper)) {}

RealBall SeriesIntegral::rate(const RealBall& t, long bits) const {
  return state_->f(t, 1, bits).coefficient(0);
}

// At the middle of the ball, and from there on by f on all of it.
RealBall SeriesIntegral::enclose(const RealBall& t, long bits) const {
  const std::vector<Part>& parts = state_->with(bits);
  const Rational at = std::clamp(t.midpoint(), state_->lower, state_->upper);
  const auto part =
      std::prev(std::upper_bound(parts.begin() + 1, parts.end(), at,
                                 [](const Rational& x, const Part& of) { return x < of.lower; }));
  const long working = bits + 64;
  const RealBall z(at - (part->lower + part->upper) / 2, working);
  const RealBall value =
      add(part->before, widened(evaluate(part->integral, z, working), part->rest), working);
  const RealBall step = subtract(t, RealBall(at, working), working);
  return step.is_zero() ? value : add_product(value, step, rate(t, working), working);
}

}  // namespace phrame
