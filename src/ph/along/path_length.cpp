#include "phrame/ph/along/path_length.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <mutex>

#include "phrame/algebra/as_written.hpp"
#include "phrame/algebra/ball_order.hpp"
#include "phrame/algebra/error.hpp"
#include "phrame/algebra/increasing.hpp"
#include "phrame/algebra/partial_sums.hpp"
#include "phrame/algebra/recent.hpp"
#include "phrame/ph/along/segment_integral.hpp"
#include "phrame/ph/curve/special_points.hpp"

namespace phrame::inline v0 {
namespace {

/// Beyond this sums of roots are not added up.
constexpr std::size_t most_roots = 16;

/// The sign of x − s. An irrational x is told from s by enough bits.
int compare_length(const Real& x, const Rational& s) {
  if (x.exact()) return (*x.exact() - s).sign();
  for (long bits = 64; bits <= 8192 || x.origin().is_irrational; bits *= 2)
    if (const int found = sign(subtract(x.enclose(bits), RealBall(s, bits), bits)); found != 0)
      return found;
  throw Undecided(
      fmt::format("arc length: {} is not told from that of a joint or of the path", as_written(s)));
}

std::string shown(const Real& length) {
  return length.exact() ? as_written(*length.exact()) : to_string(length.enclose(64), 9);
}

}  // namespace

struct PHRAME_INSIDE PathLength::State {
  /// Of a segment.
  struct SegmentLength {
    SegmentIntegral integral;
    std::optional<ArcLength> polynomial = {};  ///< where it is one

    explicit SegmentLength(const Segment& segment) : integral(arc_length(segment)) {
      const Curve* curve = ph_curve(segment);
      if (curve != nullptr && has_polynomial_length(*curve)) polynomial.emplace(*curve);
    }
  };

  Path path;
  Recent<SegmentLength> lengths{most_kept_integrals};  ///< of the segments
  PartialSums sums{};                                  ///< lengths up to segments
  std::mutex lock;
  std::vector<Surd> exact{Surd()};  ///< the first of these, as far as they are sums of square roots

  explicit State(const Path& along) : path(along) {}

  std::shared_ptr<const SegmentLength> segment(std::size_t k) {
    return lengths.get(k, [&] { return SegmentLength(path.segments()[k]); });
  }
  std::shared_ptr<const SegmentIntegral> length(std::size_t k) {
    const auto of = segment(k);
    return {of, &of->integral};
  }
  RealBall sum_before(std::size_t k, long bits);
};

/// The length up to segment k.
RealBall PathLength::State::sum_before(std::size_t k, long bits) {
  return sums.before(k, (bits + 22) / 16 * 16, [&](std::size_t n, long enough) {
    return length(n)->value(Rational(1)).enclose(enough);
  });
}

PathLength::PathLength(const Path& path) : state_(std::make_shared<State>(path)) {}

Real PathLength::before(std::size_t k) const {
  const std::lock_guard lock(state_->lock);
  std::vector<Surd>& exact = state_->exact;
  while (exact.size() <= k) {
    if (exact.back().count_roots() > most_roots) break;
    const auto next = state_->length(exact.size() - 1)->algebraic_value(1);
    if (!next) break;
    exact.push_back(exact.back() + *next);
  }
  const bool is_known = k < exact.size();
  if (is_known && exact[k].is_rational()) return exact[k].rational_part();
  return {[state = state_, k](long bits) { return state->sum_before(k, bits); }, {is_known, 0}};
}

Real PathLength::of_segment(std::size_t k) const { return state_->length(k)->value(Rational(1)); }

Real PathLength::total() const { return before(state_->path.segments().size()); }

std::shared_ptr<const ArcLength> PathLength::closed_form(std::size_t k) const {
  const auto of = state_->segment(k);
  return {of, of->polynomial ? &*of->polynomial : nullptr};
}

Real PathLength::value(const Place& at) const {
  const Real start = before(at.segment);
  if (const auto s = closed_form(at.segment); s && at.algebraic)
    return start + phrame::value(s->polynomial(), at);
  const SegmentIntegral length = *state_->length(at.segment);
  const Real sum = start + length.value(at.t);
  if (sum.exact() || !at.t.exact()) return sum;
  // Roots cancel where a curve is cut.
  const auto rest = length.algebraic_value(*at.t.exact());
  const std::lock_guard lock(state_->lock);
  if (!rest || at.segment >= state_->exact.size()) return sum;
  const Surd known = state_->exact[at.segment] + *rest;
  if (known.is_rational()) return known.rational_part();
  return known_irrational(sum);
}

RealBall PathLength::enclose(const Place& at, long bits) const {
  return add(before(at.segment).enclose(bits), state_->length(at.segment)->enclose(at.t, bits),
             bits);
}

RealBall PathLength::rate(std::size_t segment, const RealBall& t, long bits) const {
  return state_->length(segment)->rate(t, bits);
}

// Next to a rational m the length is s(m) ± (F(t) − F(m)), F′ = fσ.
std::optional<RealAlgebraic> PathLength::root_near(std::size_t segment, const Real& t,
                                                   const Rational& s) const {
  const Curve* curve = ph_curve(state_->path.segments()[segment]);
  if (curve == nullptr || !curve->is_polynomial()) return std::nullopt;
  const RealBall around = t.enclose(72);
  const Interval near =
      closed_interval(std::max(around.lower(), Rational(0)), std::min(around.upper(), Rational(1)));
  const Rational m = (*near.lower + *near.upper) / 2;
  const auto to_m = value({segment, m}).exact();
  if (!to_m || !odd(real_roots(curve->multiplier(), near)).empty()) return std::nullopt;
  const Polynomial F = arc_length(*curve);
  const Rational sign = (F(*near.upper) - F(*near.lower)).sign();
  return real_root(F - Polynomial{F(m) + sign * (s - *to_m)}, near);
}

Place PathLength::point(const Rational& s) const {
  const std::size_t count = state_->path.segments().size();
  const bool is_beyond = s >= 0 && compare_length(total(), s) < 0;
  if (is_beyond && is_rounded(s, total())) return {count - 1, Rational(1)};
  if (s < 0 || is_beyond)
    throw DomainError(
        fmt::format("arc length: {} is outside [0, {}]", as_written(s), shown(total())));
  std::size_t low = 0;
  for (std::size_t high = count; high - low > 1;) {
    const std::size_t middle = (low + high) / 2;
    (compare_length(before(middle), s) <= 0 ? low : high) = middle;
  }
  const Real start = before(low);
  if (start.exact() == s) return {low, Rational(0)};
  if (before(low + 1).exact() == s) return {low, Rational(1)};
  if (const auto length = closed_form(low); length && start.exact())
    return {low, length->algebraic_parameter(s - *start.exact())};
  const auto from_start = [*this, low](const RealBall& t, long bits) {
    return enclose({low, t.midpoint()}, bits);
  };
  const auto slope = [*this, low](const RealBall& t, long bits) { return rate(low, t, bits); };
  const auto F = std::make_shared<const IncreasingFunction>(IncreasingFunction{from_start, slope});
  const Real t = recognized(preimage(F, s, guess_preimage(*F, s)), [&](const Rational& r) {
    return value({low, r}).exact() == s;
  });
  if (t.exact()) return {low, t};
  const auto known = root_near(low, t, s);
  return known ? Place(low, *known) : Place(low, t);
}

}  // namespace phrame
