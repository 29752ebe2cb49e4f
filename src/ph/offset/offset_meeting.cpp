// Newton's step leads into no pair of arcs where their common point is at an end of one, however
// short they are. Ends of pieces are rational points, so that it is decided by algebra whether a
// piece goes through one: X − xW and Y − yW have a root in common. Arcs that are transversal have
// no second common point.
#include "phrame/ph/offset/offset_meeting.hpp"

#include <algorithm>
#include <functional>
#include <tuple>

#include "phrame/algebra/algebraic_image.hpp"
#include "phrame/algebra/ball_order.hpp"
#include "phrame/ph/curve/close_crossings.hpp"
#include "phrame/ph/offset/coincidence.hpp"
#include "phrame/ph/offset/exact_meetings.hpp"
#include "phrame/ph/offset/turning_parts.hpp"

namespace phrame::inline v0 {

Interval interval_of(const CurvePart& part) {
  return closed_interval(exact_sum(part.lower, 0).midpoint(), exact_sum(part.upper, 0).midpoint());
}

Polynomial visits_of(const RationalCurve& curve, const Vector<Rational>& at) {
  const auto gap = [&](std::size_t k) { return curve.numerator()[k] - at[k] * curve.weight(); };
  return gcd(gap(0), gap(1));
}

std::vector<RealAlgebraic> through(const RationalCurve& curve, const Vector<Rational>& at,
                                   const Interval& where) {
  std::vector<RealAlgebraic> places;
  const Polynomial common = visits_of(curve, at);
  if (common.is_constant()) return places;
  for (const RealRoot& root : real_roots(common, where)) places.push_back(root.at);
  return places;
}

namespace {

/// A point of an offset.
struct PiecePoint {
  std::size_t piece;
  RealAlgebraic t;
};

bool operator<(const PiecePoint& a, const PiecePoint& b) {
  return a.piece != b.piece ? a.piece < b.piece : compare(a.t, b.t) < 0;
}
bool are_same(const PiecePoint& a, const PiecePoint& b) { return !(a < b) && !(b < a); }

/// Two of them that are known to be one point, the first not behind the second.
struct PointPair {
  PiecePoint first;
  PiecePoint second;
};

PointPair in_order(PiecePoint a, PiecePoint b) {
  if (b < a) std::swap(a, b);
  return {std::move(a), std::move(b)};
}

bool contains(const std::vector<PointPair>& pairs, const PointPair& pair) {
  return std::ranges::any_of(pairs, [&](const PointPair& x) {
    return are_same(x.first, pair.first) && are_same(x.second, pair.second);
  });
}

/// r′ there, of any length, with the sign that counts where it is only known on one side.
Vector<RealBall> velocity(const OffsetBranches& offset, const PiecePoint& at, long bits) {
  const RationalCurve& curve = offset.curves[at.piece];
  const RealBall t = enclose(at.t, bits);
  const RealBall p = evaluate(curve.multiplier(), t, bits);
  Vector<RealBall> v;
  for (std::size_t k = 0; k < 2; ++k)
    v[k] = multiply(p, evaluate(curve.direction()[k], t, bits), bits);
  return v;
}

int crossing_sign(const OffsetBranches& offset, const PointPair& pair) {
  constexpr long bits = 256;
  const Vector<RealBall> a = velocity(offset, pair.first, bits);
  const Vector<RealBall> b = velocity(offset, pair.second, bits);
  return sign(subtract(multiply(a[0], b[1], bits), multiply(a[1], b[0], bits), bits));
}

/// The end of a piece as the start of the next one, where they meet.
PiecePoint at_start(const OffsetBranches& offset, const PiecePoint& at) {
  const std::size_t behind = offset.behind[at.piece];
  if (at.t.rational() != Rational(1) || behind == no_segment) return at;
  return {behind, Rational(0)};
}

/// Those with an end of one part in the other one.
void add_meetings(const OffsetBranches& offset, const CurvePart& one, const CurvePart& other,
                  std::vector<PointPair>& pairs) {
  for (const long end : {0L, 1L}) {
    if (end == 0 ? one.lower > 0 : one.upper < 1) continue;
    const Vector<Rational> at = point(offset.curves[one.segment], end);
    for (const RealAlgebraic& t : through(offset.curves[other.segment], at, interval_of(other))) {
      const PointPair pair = in_order({one.segment, Rational(end)}, {other.segment, t});
      const bool is_joint = are_same(at_start(offset, pair.first), at_start(offset, pair.second));
      if (!is_joint && !contains(pairs, pair) && crossing_sign(offset, pair) != 0)
        pairs.push_back(pair);
    }
  }
}

/// Each once, among the places that are found.
void add_to(SelfIntersections& result, const OffsetBranches& offset,
            const std::vector<PointPair>& pairs) {
  constexpr long bits = 96;
  std::vector<PointPair> told;
  for (const PointPair& pair : pairs) {
    const PointPair place = in_order(at_start(offset, pair.first), at_start(offset, pair.second));
    if (contains(told, place)) continue;
    told.push_back(place);
    const PiecePoint& a = place.first;
    const PiecePoint& b = place.second;
    const Crossing found{a.piece, enclose(a.t, bits), b.piece, enclose(b.t, bits),
                         crossing_sign(offset, place)};
    const auto is_behind = [&](const Crossing& x) {
      return x.first_segment != a.piece ? x.first_segment > a.piece
                                        : approximate(x.first_t) > approximate(found.first_t);
    };
    result.found.insert(std::ranges::find_if(result.found, is_behind), found);
  }
}

/// Once each.
void add_touching(SelfIntersections& result, const OffsetBranches& offset, const KnownMeeting& x) {
  const PointPair pair = in_order(at_start(offset, {x.first_segment, x.first_t}),
                                  at_start(offset, {x.second_segment, x.second_t}));
  const auto is_that = [&](const KnownMeeting& y) {
    return are_same({y.first_segment, y.first_t}, pair.first) &&
           are_same({y.second_segment, y.second_t}, pair.second);
  };
  if (!are_same(pair.first, pair.second) && std::ranges::none_of(result.touching, is_that))
    result.touching.push_back(
        {pair.first.piece, pair.first.t, pair.second.piece, pair.second.t, x.crosses});
}

/// With what is known of parts that coincide.
void add_coincidences(SelfIntersections& result, const OffsetBranches& offset,
                      const Coincidences& coincidences) {
  for (const KnownMeeting& x : coincidences.points()) add_touching(result, offset, x);
  result.coincident = coincidences.parts();
}

/// Moves what algebra decides, of all that is undecided or where resultants are short.
void decide_exactly(SelfIntersections& result, const OffsetBranches& offset, ExactMeetings& exact,
                    bool are_only_quick) {
  std::erase_if(result.undecided, [&](const UndecidedCrossing& place) {
    if (are_only_quick && !exact.is_quick(place)) return false;
    const auto meetings = exact.between(place);
    if (!meetings) return false;
    for (const Crossing& x : meetings->crossings) add_once(result.found, x);
    for (const KnownMeeting& x : meetings->touching) add_touching(result, offset, x);
    return true;
  });
}

/// Touching where parts that coincide both start or end is no place of its own.
void remove_common_ends(SelfIntersections& result, const OffsetBranches& offset) {
  std::vector<PointPair> ends;
  for (const CoincidentParts& x : result.coincident)
    for (const auto& [s, t] :
         {std::pair(x.first_from, x.second_from), std::pair(x.first_to, x.second_to)})
      ends.push_back(in_order(at_start(offset, {x.first_segment, s}),
                              at_start(offset, {x.second_segment, t})));
  std::erase_if(result.touching, [&](const KnownMeeting& x) {
    return contains(ends, {{x.first_segment, x.first_t}, {x.second_segment, x.second_t}});
  });
}

}  // namespace

OffsetBranches branches_of(const Offset& offset) {
  OffsetBranches branches;
  const std::size_t count = offset.pieces.size();
  for (std::size_t k = 0; k < count; ++k) {
    branches.curves.push_back(offset.pieces[k].curve);
    branches.behind.push_back(offset.meets[k] ? (k + 1) % count : no_segment);
    branches.turns.push_back(offset.pieces[k].turns);
  }
  return branches;
}

OffsetBranches branches_of(const Envelope& envelope) {
  OffsetBranches branches{{}, envelope.behind};
  for (const EnvelopePiece& piece : envelope.pieces) branches.curves.push_back(piece.curve);
  return branches;
}

CurveSeries plane_series(const OffsetBranches& branches) {
  CurveSeries series = plane_series(branches.curves, branches.behind);
  for (std::size_t k = 0; k < branches.turns.size(); ++k) {
    series.turning[k].parts_at_reversals = true;
    series.turning[k].breaks = branches.turns[k];
  }
  return series;
}

std::vector<Path> joined_paths(const OffsetBranches& branches) {
  const std::size_t count = branches.curves.size();
  std::vector<std::size_t> next(count, no_segment);
  std::vector<bool> is_first(count, true);
  for (std::size_t k = 0; k < count; ++k) {
    const std::size_t behind = branches.behind[k];
    if (behind == no_segment || sign_before_one(branches.curves[k].multiplier()) !=
                                    sign_after_zero(branches.curves[behind].multiplier()))
      continue;
    next[k] = behind;
    is_first[behind] = false;
  }
  std::vector<Path> found;
  std::vector<bool> is_used(count, false);
  const auto follow = [&](std::size_t k) {
    std::vector<Segment> segments;
    for (; k != no_segment && !is_used[k]; k = next[k]) {
      segments.push_back(segment_of(branches.curves[k]));
      is_used[k] = true;
    }
    found.push_back(joined(std::move(segments)));
  };
  for (std::size_t k = 0; k < count; ++k)
    if (is_first[k]) follow(k);
  for (std::size_t k = 0; k < count; ++k)  // what is closed
    if (!is_used[k]) follow(k);
  return found;
}

namespace {

SelfIntersections self_intersections(const OffsetBranches& branches, const CurveSeries& series,
                                     const Coincidences& coincidences, CrossingQuery query) {
  query.are_idle = [&coincidences, are_idle = std::move(query.are_idle)](const CurveNode& a,
                                                                         const CurveNode& b) {
    return (are_idle && are_idle(a, b)) || coincidences.cover(a, b);
  };
  SelfIntersections result = self_intersections(series, query);
  std::vector<PointPair> pairs;
  for (const auto& [first, second] : result.undecided) {
    add_meetings(branches, first, second, pairs);
    add_meetings(branches, second, first, pairs);
  }
  if (!pairs.empty()) {
    for (const auto& [a, b] : pairs) query.known.push_back({a.piece, a.t, b.piece, b.t});
    result = self_intersections(series, query);
    add_to(result, branches, pairs);
  }
  add_coincidences(result, branches, coincidences);
  // What takes least is tried first.
  ExactMeetings exact(branches, series);
  decide_exactly(result, branches, exact, true);
  look_closer(series, result);
  decide_exactly(result, branches, exact, false);
  remove_common_ends(result, branches);
  return result;
}

void narrow(std::vector<Crossing>& crossings, const CurveSeries& series, long bits) {
  for (Crossing& x : crossings) std::tie(x.first_t, x.second_t) = narrowed(series, x, bits);
}

/// With parameters known to so many bits.
SelfIntersections self_intersections(const OffsetBranches& branches, const CurveSeries& series,
                                     const Coincidences& coincidences, bool has_near_cusps,
                                     long bits) {
  CrossingQuery query;
  query.has_near_cusps = has_near_cusps;
  SelfIntersections result = self_intersections(branches, series, coincidences, std::move(query));
  narrow(result.found, series, bits);
  return result;
}

/// All pairs of a few curves by their resultants; no value where there are more, these are not all
/// short, or there is something that they do not decide.
std::optional<SelfIntersections> by_algebra(const OffsetBranches& branches,
                                            const CurveSeries& series,
                                            const Coincidences& coincidences, long bits) {
  constexpr std::size_t most_curves = 6;
  if (branches.curves.size() > most_curves) return std::nullopt;
  SelfIntersections result;
  ExactMeetings exact(branches, series);
  for (std::size_t a = 0; a < branches.curves.size(); ++a)
    for (std::size_t b = a; b < branches.curves.size(); ++b) {
      const UndecidedCrossing all{{a, 0, 1}, {b, 0, 1}};
      if (!exact.is_quick(all)) return std::nullopt;
      result.undecided.push_back(all);
    }
  add_coincidences(result, branches, coincidences);
  decide_exactly(result, branches, exact, true);
  if (!result.is_complete()) return std::nullopt;
  remove_common_ends(result, branches);
  narrow(result.found, series, bits);
  return result;
}

/// What is found of parts, told of the pieces.
class OfPieces {
 public:
  OfPieces(const std::vector<SegmentPart>& parts, long bits) : parts_(parts), bits_(bits) {}

  SelfIntersections told(SelfIntersections found) const {
    for (Crossing& x : found.found) {
      move(x.first_segment, x.first_t);
      move(x.second_segment, x.second_t);
    }
    for (KnownMeeting& x : found.touching) {
      move(x.first_segment, x.first_t);
      move(x.second_segment, x.second_t);
    }
    for (UndecidedCrossing& x : found.undecided) {
      move(x.first);
      move(x.second);
    }
    return found;
  }

 private:
  template <class T>
  void move(std::size_t& segment, T& t) const {
    const SegmentPart& part = parts_[segment];
    t = along(part, t);
    segment = part.segment;
  }
  void move(CurvePart& x) const {
    const SegmentPart& part = parts_[x.segment];
    const RealBall all = hull(*interval_of(x).lower, *interval_of(x).upper, bits_);
    const RealBall t = along(part, all);
    x = {part.segment, std::max(0.0, -upper_double(subtract({}, t, bits_))),
         std::min(1.0, upper_double(t))};
  }
  RealBall along(const SegmentPart& part, const RealBall& t) const {
    return on_segment(part, t, bits_);
  }
  static RealAlgebraic along(const SegmentPart& part, const RealAlgebraic& t) {
    return affine(t, part.upper - part.lower, part.lower);
  }

  const std::vector<SegmentPart>& parts_;
  long bits_;
};

}  // namespace

SelfIntersections self_intersections(const OffsetBranches& branches, const CurveSeries& series,
                                     CrossingQuery query) {
  return self_intersections(branches, series, Coincidences(branches, series), std::move(query));
}

// Arcs of doubles are too long next to a near-cusp, where a curve turns within little of its
// parameter. Such a curve is looked at in parts, unless its resultant is short; so are others where
// something is undecided.
SelfIntersections self_intersections(const Offset& offset, long bits) {
  constexpr long shortest = -12;  // of the exponents of parts where there is no near-cusp
  const OffsetBranches branches = branches_of(offset);
  const CurveSeries series = plane_series(branches);
  const Coincidences coincidences(branches, series);
  const std::vector<std::vector<Rational>> cuts = turning_cuts(branches);
  bool is_cut = false;
  bool has_near_cusp = false;
  for (const std::vector<Rational>& of_curve : cuts)
    for (std::size_t j = 1; j < of_curve.size(); ++j) {
      is_cut = is_cut || j > 1;
      if (binary_exponent(of_curve[j] - of_curve[j - 1]) < shortest) has_near_cusp = true;
    }
  const auto found = [&](bool are_in_parts) {
    if (!are_in_parts) return self_intersections(branches, series, coincidences, false, bits);
    const auto [fine, parts] = in_parts(branches, cuts);
    const CurveSeries of_parts = plane_series(fine);
    const Coincidences again =
        coincidences.are_none() ? Coincidences() : Coincidences(fine, of_parts);
    SelfIntersections told =
        OfPieces(parts, bits + 64).told(self_intersections(fine, of_parts, again, true, bits));
    told.coincident = coincidences.parts();
    return told;
  };
  if (has_near_cusp)
    if (auto result = by_algebra(branches, series, coincidences, bits)) return *std::move(result);
  SelfIntersections result = found(has_near_cusp);
  if (result.is_complete() || !is_cut) return result;
  SelfIntersections again = found(!has_near_cusp);
  const auto rank = [](const SelfIntersections& x) {
    return std::pair(x.is_cut_off, x.undecided.size());
  };
  return rank(again) < rank(result) ? again : result;
}

}  // namespace phrame
