#include <fmt/format.h>

#include <algorithm>

#include "phrame/algebra/error.hpp"
#include "phrame/ph/along/speed_span.hpp"
#include "phrame/ph/curve/corner.hpp"
#include "phrame/ph/curve/real_vector.hpp"
#include "phrame/ph/curve/special_points.hpp"

namespace phrame::inline v0 {
namespace {

using Kind = SpeedLimit::Kind;

constexpr const char* least_limit = "feedrate: which limit of the speed is the least is not told";
constexpr const char* slope_of_limit =
    "feedrate: whether a limit of the speed rises faster than the acceleration allows is not told";
constexpr const char* sign_of_speed = "feedrate: whether the speed is positive is not told";

/// A rational number in (a, b), not the middle, where symmetric curves have what is special.
Rational between(const Real& a, const Real& b) {
  for (long bits = 64;; bits *= 2) {
    const Rational low = a.enclose(bits).upper();
    const Rational high = b.enclose(bits).lower();
    if (low < high) return low + Rational(31, 64) * (high - low);
    if (bits > 2048) throw Undecided("feedrate: two places are not told apart");
  }
}

std::string at_parameter(std::size_t segment, const Real& t) {
  return fmt::format("at t = {:.9g}", static_cast<double>(segment) + approximate(t.enclose(64)));
}

/// Parts of one path.
class BoundSearch {
 public:
  BoundSearch(const Path& path, const PathLength& length, const Feedrate& feedrate,
              const SpeedLimits& limits)
      : path_(path), length_(length), feedrate_(feedrate), limits_(limits) {}

  SpeedSpans spans();

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
  const SpeedLimits& limits_;
  SpeedSpans spans_;
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

SpeedSpans BoundSearch::spans() {
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
    return sign_changes(limits_.difference(a, b, segment), from, to, least_limit);
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
  for (const Real& zero : sign_changes(V, t0, t1, sign_of_speed)) refuse(zero);
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
          sign_changes(limits_.excess(limit, side, segment), from.t, to.t, slope_of_limit);
      cuts.insert(cuts.end(), at.begin(), at.end());
    }
    std::sort(cuts.begin() + 1, cuts.end(),
              [](const Real& a, const Real& b) { return order(a, b) < 0; });
  }
  for (std::size_t k = 0; k + 1 < cuts.size(); ++k) {
    const Cut first = k == 0 ? from : cut_at(segment, cuts[k]);
    const Cut last = k + 2 == cuts.size() ? to : cut_at(segment, cuts[k + 1]);
    SpeedSpan span{limit, segment, first.t, last.t, first.s, last.s};
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
      const bool goes_on = other.kind == Kind::normal && limit.kind == Kind::normal &&
                           (!is_at_joint || limits_.curvature_goes_on(segment));
      span.jumps =
          !goes_on &&
          (jumps_ || (is_at_joint && (other.depends_on_curvature || limit.depends_on_curvature)));
    }
    span.stops = stops_;
    jumps_ = false;
    stops_ = false;
    spans_.push_back(std::move(span));
  }
}

}  // namespace

SpeedSpans least_limits(const Path& path, const PathLength& length, const Feedrate& feedrate,
                        const SpeedLimits& limits) {
  return BoundSearch(path, length, feedrate, limits).spans();
}

}  // namespace phrame
