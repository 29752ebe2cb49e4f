#include "phrame/ph/along/speed_profile.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "phrame/algebra/as_written.hpp"
#include "phrame/algebra/error.hpp"
#include "phrame/algebra/increasing.hpp"
#include "phrame/algebra/partial_sums.hpp"
#include "phrame/ph/along/segment_time.hpp"
#include "phrame/ph/along/speed_span.hpp"
#include "phrame/ph/curve/real_vector.hpp"

namespace phrame::inline v0 {
namespace {

using Kind = SpeedLimit::Kind;

/// Where no quantity is named, V is one function.
std::vector<Feedrate::Piece> pieces_of(const Feedrate& feedrate) {
  if (!feedrate.pieces.empty()) return feedrate.pieces;
  return {{{{{formula_of(feedrate.speed), feedrate.of}}}}};
}

/// The time along the piece, and what tells that of its parts.
void add_time(SpeedProfile::Piece& piece, const SpeedLimits& limits,
              const std::optional<Rational>& acceleration) {
  if (!piece.limit) {
    const Real gain = square_root_of(piece.w1) + -square_root_of(piece.w0);
    piece.duration = cached(Real(Rational(piece.slope / *acceleration)) * gain);
  } else if (piece.limit->kind == Kind::constant) {
    piece.duration = cached(quotient_of(piece.s1 + -piece.s0, piece.limit->constant));
  } else {
    const SeriesFunction rate = limits.time_rate(*piece.limit, piece.segment);
    piece.integral = std::make_shared<const SeriesIntegral>(rate, below(piece.t0), above(piece.t1));
    piece.duration = cached(Real([F = piece.integral, a = piece.t0, b = piece.t1](long bits) {
      return subtract(F->enclose(b.enclose(bits + 8), bits + 8),
                      F->enclose(a.enclose(bits + 8), bits + 8), bits + 8);
    }));
  }
}

}  // namespace

/// Of durations.
struct SpeedProfile::Sums {
  std::vector<Real> durations;
  std::vector<Rational> exact{Rational(0)};  ///< the first sums, as far as they are
  PartialSums sums{};

  RealBall before(std::size_t k, long bits) {
    return sums.before(k, (bits + 22) / 16 * 16,
                       [&](std::size_t n, long enough) { return durations[n].enclose(enough); });
  }
};

SpeedProfile::SpeedProfile(const Path& path, const PathLength& length, const Feedrate& feedrate,
                           const std::optional<Vector<Rational>>& normal)
    : path_(path),
      length_(length),
      acceleration_(feedrate.limits.tangential),
      sums_(std::make_shared<Sums>()) {
  Feedrate in_pieces = feedrate;
  in_pieces.pieces = pieces_of(feedrate);
  const SpeedLimits limits(length_, path_, feedrate.limits, normal);
  SpeedSpans spans = least_limits(path_, length_, in_pieces, limits);
  if (acceleration_) spans = with_bounded_slope(spans, limits, length_, feedrate.limits);
  for (const SpeedSpan& span : spans) {
    const bool is_constant = span.limit && span.limit->kind == Kind::constant;
    if (is_constant && !pieces_.empty() && pieces_.back().limit &&
        pieces_.back().limit->constant.exact() && pieces_.back().limit->kind == Kind::constant &&
        pieces_.back().limit->constant.exact() == span.limit->constant.exact()) {
      pieces_.back().s1 = span.s1;
      continue;
    }
    pieces_.push_back({span.limit, span.segment, span.t0, span.t1, span.s0, span.s1, span.w0.value,
                       span.w1.value, span.rise == 0 ? 1 : -1});
  }
  for (Piece& piece : pieces_) {
    add_time(piece, limits, acceleration_);
    sums_->durations.push_back(piece.duration);
    if (piece.duration.exact() && sums_->exact.size() == sums_->durations.size())
      sums_->exact.push_back(sums_->exact.back() + *piece.duration.exact());
  }
}

Real SpeedProfile::start(std::size_t piece) const {
  if (piece < sums_->exact.size()) return sums_->exact[piece];
  return Real([sums = sums_, piece](long bits) { return sums->before(piece, bits); });
}

/// The last one that starts at that time or before.
std::size_t SpeedProfile::piece_at(const Rational& time) const {
  std::size_t low = 0;
  for (std::size_t high = pieces_.size(); high - low > 1;) {
    const std::size_t middle = (low + high) / 2;
    const Real since = Real(time) + -start(middle);
    const int found = sign_of(since);
    if (found == 0 && !since.exact())
      throw Undecided(
          fmt::format("feedrate: the time {} is not told from one at which the motion "
                      "changes",
                      as_written(time)));
    (found >= 0 ? low : high) = middle;
  }
  return low;
}

Place SpeedProfile::place_at(const Real& s) const {
  if (s.exact()) return length_.point(*s.exact());
  std::size_t low = 0;
  for (std::size_t high = path_.segments().size(); high - low > 1;) {
    const std::size_t middle = (low + high) / 2;
    (order(length_.before(middle), s) <= 0 ? low : high) = middle;
  }
  const auto F = std::make_shared<const IncreasingFunction>(IncreasingFunction{
      [length = length_, low, s](const RealBall& t, long bits) {
        return subtract(length.enclose({low, t.midpoint()}, bits), s.enclose(bits), bits);
      },
      [length = length_, low](const RealBall& t, long bits) { return length.rate(low, t, bits); }});
  return {low, preimage(F, 0, guess_preimage(*F, 0))};
}

std::pair<Place, Real> SpeedProfile::at_time(const Rational& time) const {
  const std::size_t k = piece_at(time);
  const Piece& piece = pieces_[k];
  const Real since = Real(time) + -start(k);
  if (!piece.limit || piece.limit->kind == Kind::constant) {
    const Real v = piece.limit ? piece.limit->constant : square_root_of(piece.w0);
    Real s = piece.s0 + v * since;
    if (!piece.limit) s = s + Real(Rational(piece.slope * *acceleration_ / 2)) * (since * since);
    s = cached(s);
    return {place_at(s), s};
  }
  if (since.exact() == Rational(0)) return {Place(piece.segment, piece.t0), piece.s0};
  // F is 0 where the time has passed since t0.
  const Real passed = cached(Real([F = piece.integral, a = piece.t0, since](long bits) {
    return add(F->enclose(a.enclose(bits + 8), bits + 8), since.enclose(bits + 8), bits + 8);
  }));
  const Real t = zero_between(
      below(piece.t0), above(piece.t1),
      {[F = piece.integral, passed](const RealBall& at, long bits) {
         return subtract(F->enclose(at, bits), passed.enclose(bits), bits);
       },
       [F = piece.integral](const RealBall& at, long bits) { return F->rate(at, bits); }});
  const Place at(piece.segment, t);
  return {at, length_.value(at)};
}

Real SpeedProfile::speed(const Rational& time, const Place& at) const {
  const std::size_t k = piece_at(time);
  const Piece& piece = pieces_[k];
  const Real since = Real(time) + -start(k);
  if (since.exact() == Rational(0)) return square_root_of(piece.w0);
  if (piece.integral)
    return Real([G = piece.integral, length = length_, at](long bits) {
      const RealBall t = at.t.enclose(bits + 8);
      return divide(length.rate(at.segment, t, bits + 8), G->rate(t, bits + 8), bits + 8);
    });
  if (piece.limit) return piece.limit->constant;
  return square_root_of(piece.w0) + Real(Rational(piece.slope * *acceleration_)) * since;
}

Real SpeedProfile::time(const Place& at) const {
  const Real s = length_.value(at);
  std::size_t k = 0;
  for (std::size_t high = pieces_.size(); high - k > 1;) {
    const std::size_t middle = (k + high) / 2;
    (order(pieces_[middle].s0, s) <= 0 ? k : high) = middle;
  }
  const Piece& piece = pieces_[k];
  const Real way = s + -piece.s0;
  if (piece.integral)
    return start(k) + Real([F = piece.integral, a = piece.t0, t = at.t](long bits) {
             return subtract(F->enclose(t.enclose(bits + 8), bits + 8),
                             F->enclose(a.enclose(bits + 8), bits + 8), bits + 8);
           });
  if (piece.limit) return start(k) + quotient_of(way, piece.limit->constant);
  const Rational& A = *acceleration_;
  const Real w = piece.w0 + Real(Rational(2 * piece.slope * A)) * way;
  return start(k) +
         Real(Rational(piece.slope / A)) * (square_root_of(w) + -square_root_of(piece.w0));
}

}  // namespace phrame
