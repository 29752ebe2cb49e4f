#include "phrame/ph/along/speed_profile.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <mutex>
#include <utility>

#include "phrame/algebra/as_written.hpp"
#include "phrame/algebra/error.hpp"
#include "phrame/algebra/increasing.hpp"
#include "phrame/ph/along/segment_time.hpp"
#include "phrame/ph/curve/corner.hpp"
#include "phrame/ph/curve/real_vector.hpp"
#include "phrame/ph/curve/special_points.hpp"

// The greatest w ≤ B with |w′| ≤ 2A is found by two walks. Along the path a line of slope 2A leaves
// B where B′ > 2A or B jumps up, and ends where it meets B again; that is the greatest one with
// w′ ≤ 2A. The same walk back over it bounds −w′, and keeps the other bound: where a line of slope
// −2A is the least, w′ = −2A.
//
// On each part of a segment one limit is the least, and the signs of its B′ ± 2A do not change:
// then a line meets it at most once, and whether it does is told by the end of the part.

namespace phrame::inline v0 {
namespace {

using Kind = SpeedLimit::Kind;

constexpr const char* least_limit = "feedrate: which limit of the speed is the least is not told";
constexpr const char* slope_of_limit =
    "feedrate: whether a limit of the speed rises faster than the acceleration allows is not told";
constexpr const char* sign_of_speed = "feedrate: whether the speed is positive is not told";

int order(const Real& a, const Real& b) {
  const Real difference = a + -b;
  const int found = sign_of(difference);
  if (found == 0 && !difference.exact())
    throw Undecided("feedrate: two places where the motion changes are not told apart");
  return found;
}

/// A rational number in (a, b), not the middle, where symmetric curves have what is special.
Rational between(const Real& a, const Real& b) {
  for (long bits = 64;; bits *= 2) {
    const Rational low = a.enclose(bits).upper();
    const Rational high = b.enclose(bits).lower();
    if (low < high) return low + Rational(31, 64) * (high - low);
    if (bits > 2048) throw Undecided("feedrate: two places are not told apart");
  }
}

Rational below(const Real& t) {
  return t.exact() ? *t.exact() : std::max(Rational(0), t.enclose(96).lower());
}
Rational above(const Real& t) {
  return t.exact() ? *t.exact() : std::min(Rational(1), t.enclose(96).upper());
}

/// Where f changes its sign in (a, b).
std::vector<Real> changes_within(const SeriesFunction& f, const Real& a, const Real& b,
                                 const std::string& what) {
  std::vector<Real> found = sign_changes(f, below(a), above(b), what);
  std::erase_if(found, [&](const Real& t) {
    return (!a.exact() && order(t, a) <= 0) || (!b.exact() && order(t, b) >= 0);
  });
  return found;
}

/// A part of a segment on which one limit is the least, or of the path on which w is linear.
struct Span {
  std::optional<SpeedLimit> limit;
  std::size_t segment = 0;
  Real t0 = Rational(0);
  Real t1 = Rational(0);
  Real s0 = Rational(0);
  Real s1 = Rational(0);
  SquaredSpeed w0 = {Rational(0)};  ///< w at s0 and at s1
  SquaredSpeed w1 = {Rational(0)};
  int rise = -1;       ///< the sign of w′ − 2A inside
  int fall = 1;        ///< that of w′ + 2A
  bool jumps = false;  ///< may w jump at s0?
  bool stops = false;  ///< has the motion to stop there?
};

using Spans = std::vector<Span>;

std::string at_parameter(std::size_t segment, const Real& t) {
  return fmt::format("at t = {:.9g}", static_cast<double>(segment) + approximate(t.enclose(64)));
}

/// Parts of one path.
class BoundSearch {
 public:
  BoundSearch(const Path& path, const PathLength& length, const Feedrate& feedrate,
              const std::optional<Vector<Rational>>& normal)
      : path_(path),
        length_(length),
        feedrate_(feedrate),
        limits_(length, path, feedrate.limits, normal) {}

  Spans spans();
  const SpeedLimits& limits() const { return limits_; }

 private:
  using Choice = std::vector<std::vector<SpeedLimit>>;  ///< the least of greatest ones

  /// Where a piece of the feedrate starts.
  struct PieceStart {
    std::size_t piece;
    Place at;
    Real s;
  };
  /// A place on a segment.
  struct Cut {
    Real t;
    Real s;
  };

  std::vector<PieceStart> starts_of_pieces() const;
  void add(std::size_t segment, const Feedrate::Piece& piece, const Cut& from, const Cut& to);
  void add(std::size_t segment, const SpeedLimit& limit, const Cut& from, const Cut& to);
  std::vector<Real> changes_of(const SpeedLimit& a, const SpeedLimit& b, std::size_t segment,
                               const Real& from, const Real& to) const;
  const SpeedLimit& least_at(const Choice& choice, std::size_t segment, const Rational& t) const;
  void require_positive(std::size_t segment, const SpeedLimit& limit, const Real& t0,
                        const Real& t1) const;
  Cut cut_at(std::size_t segment, const Real& t) const {
    return {t, cached(length_.value({segment, t}))};
  }

  const Path& path_;
  const PathLength& length_;
  const Feedrate& feedrate_;
  SpeedLimits limits_;
  Spans spans_;
  bool jumps_ = false;  ///< may the limit jump at what is added next?
  bool stops_ = false;
};

/// Those within the path; the first one is at its start.
std::vector<BoundSearch::PieceStart> BoundSearch::starts_of_pieces() const {
  std::vector<PieceStart> starts{{0, {0, Rational(0)}, Rational(0)}};
  const bool by_parameter = feedrate_.ends_are_parameters;
  const Real total = by_parameter ? Real(path_.end()) : length_.total();
  for (std::size_t k = 0; k + 1 < feedrate_.pieces.size(); ++k) {
    const Rational& end = *feedrate_.pieces[k].end;
    if (end <= 0) {
      starts.back().piece = k + 1;
      continue;
    }
    if (order(total, end) <= 0) break;
    const Place at = by_parameter ? Place(locate(path_, end)) : length_.point(end);
    starts.push_back({k + 1, at, by_parameter ? length_.value(at) : Real(end)});
  }
  return starts;
}

Spans BoundSearch::spans() {
  const std::vector<PieceStart> starts = starts_of_pieces();
  std::vector<std::size_t> stops;
  if (feedrate_.limits.normal)
    for (const Corner& corner : corners(path_))
      if (corner.segment > 0 && sign_of(corner.angle + Real(Rational(-1, 1'000'000))) > 0)
        stops.push_back(corner.segment);
  if (!stops.empty() && !feedrate_.limits.tangential)
    throw DomainError(
        fmt::format("feedrate: the path has a corner at t = {}, where a normal "
                    "acceleration is infinite without a limit of the tangential one",
                    stops.front()));
  std::size_t next = 1;
  for (std::size_t k = 0; k < path_.segments().size(); ++k) {
    stops_ = std::ranges::find(stops, k) != stops.end();
    Cut from{Rational(0), length_.before(k)};
    for (; next < starts.size() && starts[next].at.segment == k; ++next) {
      if (starts[next].at.t.exact() != Rational(0)) {
        const Cut to{starts[next].at.t, starts[next].s};
        add(k, feedrate_.pieces[starts[next - 1].piece], from, to);
        from = to;
      }
      jumps_ = true;
    }
    add(k, feedrate_.pieces[starts[next - 1].piece], from, {Rational(1), length_.before(k + 1)});
  }
  return std::move(spans_);
}

/// Where the less of two limits changes. What touches is told by algebra, where it can be.
std::vector<Real> BoundSearch::changes_of(const SpeedLimit& a, const SpeedLimit& b,
                                          std::size_t segment, const Real& from,
                                          const Real& to) const {
  try {
    return changes_within(limits_.difference(a, b, segment), from, to, least_limit);
  } catch (const Undecided&) {
    const auto p = limits_.algebraic_difference(a, b, segment);
    if (!p) throw;
    std::vector<Real> found;
    for (const RealRoot& root : odd(real_roots(*p, open_interval(0, 1))))
      if (const Real t = to_real(root.at); order(t, from) > 0 && order(t, to) < 0)
        found.push_back(t);
    return found;
  }
}

/// The parts on which one limit is the least.
void BoundSearch::add(std::size_t segment, const Feedrate::Piece& piece, const Cut& from,
                      const Cut& to) {
  Choice choice;
  for (const auto& group : piece.least_of) {
    choice.emplace_back();
    for (const Feedrate::Function& f : group) choice.back().push_back(limits_.limit(f));
  }
  if (feedrate_.limits.normal)
    if (auto limit = limits_.normal_limit(segment)) choice.push_back({std::move(*limit)});
  std::vector<const SpeedLimit*> all;
  for (const auto& group : choice)
    for (const SpeedLimit& limit : group) all.push_back(&limit);
  if (std::ranges::any_of(all, [](const auto* limit) { return limit->kind != Kind::constant; }))
    limits_.require_regular(segment);
  std::vector<Real> cuts{from.t, to.t};
  for (std::size_t i = 0; i < all.size(); ++i)
    for (std::size_t j = 0; j < i; ++j) {
      if (all[i]->kind == Kind::constant && all[j]->kind == Kind::constant) continue;
      const std::vector<Real> at = changes_of(*all[i], *all[j], segment, from.t, to.t);
      cuts.insert(cuts.end(), at.begin(), at.end());
    }
  std::sort(cuts.begin() + 1, cuts.end(),
            [](const Real& a, const Real& b) { return order(a, b) < 0; });
  for (std::size_t k = 0; k + 1 < cuts.size();) {
    const SpeedLimit& limit = least_at(choice, segment, between(cuts[k], cuts[k + 1]));
    std::size_t end = k + 1;
    while (end + 1 < cuts.size() &&
           &least_at(choice, segment, between(cuts[end], cuts[end + 1])) == &limit)
      ++end;
    add(segment, limit, k == 0 ? from : cut_at(segment, cuts[k]),
        end + 1 == cuts.size() ? to : cut_at(segment, cuts[end]));
    k = end;
  }
}

/// The limit that is the speed at t, where no two are equal, but for constants that are so all
/// along.
const SpeedLimit& BoundSearch::least_at(const Choice& choice, std::size_t segment,
                                        const Rational& t) const {
  const auto is_less = [&](const SpeedLimit& a, const SpeedLimit& b) {
    if (a.kind == Kind::constant && b.kind == Kind::constant)
      return compare(limits_.squared(a, segment, t), limits_.squared(b, segment, t),
                     at_parameter(segment, t)) < 0;
    return sign_at(limits_.difference(a, b, segment), t) < 0;
  };
  const SpeedLimit* least = nullptr;
  for (const auto& group : choice) {
    const SpeedLimit* greatest = group.data();
    for (const SpeedLimit& limit : group)
      if (&limit != greatest && is_less(*greatest, limit)) greatest = &limit;
    if (least == nullptr || is_less(*greatest, *least)) least = greatest;
  }
  return *least;
}

void BoundSearch::require_positive(std::size_t segment, const SpeedLimit& limit, const Real& t0,
                                   const Real& t1) const {
  const auto refuse = [&](const Real& t) {
    throw DomainError("feedrate: the speed is 0 or negative " + at_parameter(segment, t));
  };
  if (limit.kind == Kind::normal) return;
  if (limit.kind == Kind::constant) {
    if (sign_of(limit.constant) <= 0) refuse(t0);
    return;
  }
  const SeriesFunction V = limits_.speed(limit, segment);
  for (const Rational& end : {below(t0), above(t1)})
    if (sign_at(V, end) <= 0) refuse(end);
  for (const Real& zero : changes_within(V, t0, t1, sign_of_speed)) refuse(zero);
}

/// The parts on which it rises, or falls, faster than is allowed, and those where it does not.
void BoundSearch::add(std::size_t segment, const SpeedLimit& limit, const Cut& from,
                      const Cut& to) {
  require_positive(segment, limit, from.t, to.t);
  std::vector<Real> cuts{from.t, to.t};
  const bool is_bounded = feedrate_.limits.tangential && limit.kind != Kind::constant;
  if (is_bounded) {
    for (const int side : {1, -1}) {
      const auto at =
          changes_within(limits_.excess(limit, side, segment), from.t, to.t, slope_of_limit);
      cuts.insert(cuts.end(), at.begin(), at.end());
    }
    std::sort(cuts.begin() + 1, cuts.end(),
              [](const Real& a, const Real& b) { return order(a, b) < 0; });
  }
  for (std::size_t k = 0; k + 1 < cuts.size(); ++k) {
    const Cut first = k == 0 ? from : cut_at(segment, cuts[k]);
    const Cut last = k + 2 == cuts.size() ? to : cut_at(segment, cuts[k + 1]);
    Span span{limit, segment, first.t, last.t, first.s, last.s};
    span.w0 = limits_.squared(limit, segment, span.t0);
    span.w1 = limits_.squared(limit, segment, span.t1);
    if (is_bounded) {
      const Rational middle = between(span.t0, span.t1);
      span.rise = sign_at(limits_.excess(limit, 1, segment), middle);
      span.fall = sign_at(limits_.excess(limit, -1, segment), middle);
    }
    // The limit goes on but where pieces of V meet, and at joints where the curvature jumps.
    if (!spans_.empty() && k == 0) {
      const SpeedLimit& other = *spans_.back().limit;
      const bool is_at_joint = spans_.back().segment != segment;
      const bool goes_on = other.kind == Kind::normal && limit.kind == Kind::normal;
      span.jumps = is_at_joint ? jumps_ || other.depends_on_curvature || limit.depends_on_curvature
                               : jumps_ && !goes_on;
    }
    span.stops = stops_;
    jumps_ = false;
    stops_ = false;
    spans_.push_back(std::move(span));
  }
}

// ---- the walks

/// A walk along the spans, forward or back.
class Walk {
 public:
  Walk(const SpeedLimits& limits, const PathLength& length, const Rational& acceleration,
       int direction)
      : limits_(limits), length_(length), slope_(2 * acceleration), direction_(direction) {}

  /// From the speed at the end where it starts on, or from the limit there.
  Spans operator()(const Spans& spans, const Rational& start_speed);

 private:
  bool forward() const { return direction_ > 0; }
  const Real& entry(const Span& span) const { return forward() ? span.s0 : span.s1; }
  const Real& exit(const Span& span) const { return forward() ? span.s1 : span.s0; }
  const SquaredSpeed& w_entry(const Span& span) const { return forward() ? span.w0 : span.w1; }
  const SquaredSpeed& w_exit(const Span& span) const { return forward() ? span.w1 : span.w0; }
  std::string where(const Real& s) const {
    return fmt::format("at s = {:.9g}", approximate(s.enclose(64)));
  }

  Real line(const Real& s) const {
    return anchor_w_ + Real(direction_ * slope_) * (s + -anchor_s_);
  }
  void leave(const Real& s, const Real& w);
  void finish_line(const Real& s);
  void pass(const Span& span);
  Span cut(const Span& span, const Real& t, const Real& s, const Real& w) const;
  void meet(const Span& span);

  const SpeedLimits& limits_;
  const PathLength& length_;
  Rational slope_;
  int direction_;
  bool on_line_ = false;
  Real anchor_s_ = Rational(0);
  Real anchor_w_ = Rational(0);
  bool stops_ = false;  ///< does the line start at a stop?
  Spans out_;
};

void Walk::leave(const Real& s, const Real& w) {
  on_line_ = true;
  anchor_s_ = s;
  anchor_w_ = w;
}

/// The line ends at s.
void Walk::finish_line(const Real& s) {
  Span span;
  const Real w = line(s);
  span.s0 = forward() ? anchor_s_ : s;
  span.s1 = forward() ? s : anchor_s_;
  span.w0 = {forward() ? anchor_w_ : w};
  span.w1 = {forward() ? w : anchor_w_};
  span.rise = forward() ? 0 : -1;
  span.fall = forward() ? 1 : 0;
  span.stops = std::exchange(stops_, false);
  out_.push_back(std::move(span));
  on_line_ = false;
}

/// What is left of the span behind the place where the line meets it.
Span Walk::cut(const Span& span, const Real& t, const Real& s, const Real& w) const {
  Span rest = span;
  (forward() ? rest.t0 : rest.t1) = t;
  (forward() ? rest.s0 : rest.s1) = s;
  (forward() ? rest.w0 : rest.w1) = {w};
  if (forward()) rest.jumps = rest.stops = false;
  return rest;
}

/// The line is below the span where that starts and above it where it ends.
void Walk::meet(const Span& span) {
  if (!span.limit || span.limit->kind == Kind::constant) {
    // Exact where the anchor is: w there, or half way between the two lines, of which the one of
    // the first walk rises as this one falls.
    const Real from_anchor =
        Real(Rational(direction_ / slope_)) * ((span.limit ? span.w0 : span.w1).value + -anchor_w_);
    const Real s = cached(span.limit ? anchor_s_ + from_anchor
                                     : Real(Rational(1, 2)) * (anchor_s_ + from_anchor + span.s1));
    const Real w = span.limit ? span.w0.value : cached(line(s));
    finish_line(s);
    out_.push_back(cut(span, Rational(0), s, w));
    return;
  }
  const std::size_t k = span.segment;
  const SeriesFunction V = limits_.speed(*span.limit, k);
  // 2A(s − s_anchor) + w_anchor − V² rises along the walk.
  const auto gap = [length = length_, V, k, w = anchor_w_, from = anchor_s_,
                    steep = direction_ * slope_](const RealBall& t, long terms, long bits) {
    const BallPolynomial v = V(t, terms, bits);
    const Real at([t](long) { return t; });
    const RealBall s = length.enclose({k, at}, bits);
    const RealBall v0 = v.coefficient(0);
    const RealBall rise =
        multiply(RealBall(steep, bits), subtract(s, from.enclose(bits), bits), bits);
    const RealBall value = subtract(add(rise, w.enclose(bits), bits), multiply(v0, v0, bits), bits);
    if (terms == 1) return BallPolynomial(std::vector<RealBall>{value});
    const RealBall slope =
        subtract(multiply(RealBall(steep, bits), length.rate(k, t, bits), bits),
                 times_power_of_two(multiply(v0, v.coefficient(1), bits), 1), bits);
    return BallPolynomial(std::vector<RealBall>{value, slope});
  };
  const auto at = changes_within(gap, span.t0, span.t1,
                                 "feedrate: where the motion meets its limit is not told");
  if (at.size() != 1) throw Undecided("feedrate: where the motion meets its limit is not told");
  const Real s = cached(length_.value({k, at[0]}));
  const Real w = limits_.squared(*span.limit, k, at[0]).value;
  finish_line(s);
  out_.push_back(cut(span, at[0], s, w));
}

void Walk::pass(const Span& span) {
  const int excess = forward() ? span.rise : -span.fall;
  if (!on_line_ && excess > 0) leave(entry(span), w_entry(span).value);
  if (!on_line_) {
    out_.push_back(span);
    return;
  }
  if (excess > 0) return;
  const int above = compare(w_exit(span), {line(exit(span))}, where(exit(span)));
  if (above > 0) return;
  if (above == 0) return finish_line(exit(span));
  meet(span);
}

Spans Walk::operator()(const Spans& spans, const Rational& start_speed) {
  const Span* before = nullptr;
  for (std::size_t j = 0; j < spans.size(); ++j) {
    const Span& span = forward() ? spans[j] : spans[spans.size() - 1 - j];
    const bool stops = before != nullptr && (forward() ? span : *before).stops;
    const bool jumps = before != nullptr && (forward() ? span : *before).jumps;
    if (before == nullptr) {
      const Rational w = start_speed * start_speed;
      const int above = compare(w_entry(span), {w, Rational(w * w)}, where(entry(span)));
      if (above < 0)
        throw DomainError(fmt::format(
            "feedrate: the speed {} at the {} of the path is more than the motion {}: at most {}",
            as_written(start_speed), forward() ? "start" : "end",
            forward() ? "may have there" : "reaches",
            to_string(sqrt_of_nonnegative(w_entry(span).value.enclose(64), 64), 9)));
      if (above > 0) leave(entry(span), w);
    } else if (stops) {
      if (on_line_) finish_line(entry(span));
      leave(entry(span), Rational(0));
      stops_ = forward();
    } else if (jumps) {
      const SquaredSpeed reached = on_line_ ? SquaredSpeed{line(entry(span))} : w_exit(*before);
      const int above = compare(w_entry(span), reached, where(entry(span)));
      if (above > 0 && !on_line_) leave(entry(span), w_exit(*before).value);
      if (above <= 0 && on_line_) finish_line(entry(span));
    }
    pass(span);
    before = &span;
  }
  if (on_line_ && !forward())
    throw DomainError(
        fmt::format("feedrate: from the speed at the start of the path the motion cannot brake in "
                    "time: at most {}",
                    to_string(sqrt_of_nonnegative(line(exit(*before)).enclose(64), 64), 9)));
  if (on_line_) finish_line(exit(*before));
  if (!forward()) std::reverse(out_.begin(), out_.end());
  return std::move(out_);
}

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

struct SpeedProfile::Sums {
  std::vector<Real> durations;
  std::vector<Rational> exact{Rational(0)};  ///< times up to pieces, as far as they are
  std::mutex lock{};
  std::map<long, std::vector<RealBall>> sums{};  ///< of durations, by bits

  RealBall before(std::size_t k, long bits) {
    const long enough = (bits + 22) / 16 * 16;
    const std::lock_guard locked(lock);
    std::vector<RealBall>& known = sums[enough];
    if (known.empty()) known.emplace_back();
    while (known.size() <= k)
      known.push_back(add(known.back(), durations[known.size() - 1].enclose(enough), enough));
    return known[k];
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
  BoundSearch search(path_, length_, in_pieces, normal);
  Spans spans = search.spans();
  if (acceleration_) {
    const SpeedLimits& limits = search.limits();
    spans = Walk(limits, length_, *acceleration_, 1)(spans, feedrate.limits.start_speed);
    spans = Walk(limits, length_, *acceleration_, -1)(spans, feedrate.limits.end_speed);
  }
  for (const Span& span : spans) {
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
    add_time(piece, search.limits(), acceleration_);
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
  const Rational from = below(piece.t0);
  const Rational width = above(piece.t1) - from;
  const auto place = [from, width](const RealBall& u, long bits) {
    return add_product(RealBall(from, bits), RealBall(width, bits), u, bits);
  };
  // F is 0 where the time has passed since t0.
  const Real passed = cached(Real([F = piece.integral, a = piece.t0, since](long bits) {
    return add(F->enclose(a.enclose(bits + 8), bits + 8), since.enclose(bits + 8), bits + 8);
  }));
  const auto F = std::make_shared<const IncreasingFunction>(IncreasingFunction{
      [G = piece.integral, place, passed](const RealBall& u, long bits) {
        return subtract(G->enclose(place(u, bits), bits), passed.enclose(bits), bits);
      },
      [G = piece.integral, place, width](const RealBall& u, long bits) {
        return multiply(RealBall(width, bits), G->rate(place(u, bits), bits), bits);
      }});
  const Real t = cached(Real(from) + Real(width) * preimage(F, 0, guess_preimage(*F, 0)));
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
