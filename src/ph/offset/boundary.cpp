// Where what is left of a boundary curve changes, at a point Q, another boundary curve goes through
// Q, or the curve has a cusp or an event there: so between two such places one point tells for all.
// A part that is inside one disc has none.
//
// Where branches coincide one does not cross the other, and the ends of each cut the other one.
#include "phrame/ph/offset/boundary.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <map>

#include "phrame/algebra/error.hpp"
#include "phrame/ph/curve/close_crossings.hpp"
#include "phrame/ph/curve/vector.hpp"
#include "phrame/ph/offset/exact_meetings.hpp"

namespace phrame::inline v0 {
namespace {

constexpr long place_bits = 320;
constexpr long closest_place_bits = 3200;

/// t of the line where it crosses the other one, which is not parallel.
Rational share_up_to(const RationalCurve& line, const RationalCurve& other) {
  const Vector<Rational> from = point(line, 0);
  const Vector<Rational> way = point(line, 1) - from;
  const Vector<Rational> start = point(other, 0);
  const Vector<Rational> across = point(other, 1) - start;
  const Vector<Rational> gap = start - from;
  return (gap[0] * across[1] - gap[1] * across[0]) / (way[0] * across[1] - way[1] * across[0]);
}

/// Where in a part of the curve it meets the line or the circle that another one is part of; no
/// value where that is part of none, or this one, too.
std::optional<std::vector<RealAlgebraic>> meetings(const RationalCurve& curve,
                                                   const CurvePart& part,
                                                   const RationalCurve& other,
                                                   const std::optional<Vector<Rational>>& center) {
  if (!center && !is_line(other)) return std::nullopt;
  const Vector<Rational> from = point(other, 0);
  const auto across = [&](std::size_t k, const Vector<Rational>& origin) {
    return curve.numerator()[k] - origin[k] * curve.weight();
  };
  Polynomial gap;
  if (center) {
    const Vector<Rational> radius = from - *center;
    gap = across(0, *center) * across(0, *center) + across(1, *center) * across(1, *center) -
          dot(radius, radius) * curve.weight() * curve.weight();
  } else {
    const Vector<Rational> way = point(other, 1) - from;
    gap = way[0] * across(1, from) - way[1] * across(0, from);
  }
  if (gap.is_zero()) return std::nullopt;
  std::vector<RealAlgebraic> found;
  for (const RealRoot& root : real_roots(gap, interval_of(part))) found.push_back(root.at);
  return found;
}

/// Sets that are joined.
class Classes {
 public:
  std::size_t add() { return parents_.emplace_back(parents_.size()); }
  std::size_t of(std::size_t x) {
    while (parents_[x] != x) x = parents_[x] = parents_[parents_[x]];
    return x;
  }
  void join(std::size_t a, std::size_t b) { parents_[of(a)] = of(b); }

 private:
  std::vector<std::size_t> parents_;
};

/// A place of a piece at which its distance from the path may change.
struct Event {
  Real t;
  RealBall ball;                            ///< around t
  std::size_t place;                        ///< a class: one point of the plane
  bool is_fuzzy = false;                    ///< may it be none, or several?
  std::optional<RealAlgebraic> exact = {};  ///< t, where that is known
  std::optional<Crossing> crossing = {};    ///< that it is the place of, where it is one
};

/// Are both known to be one place?
bool are_same(const Event& a, const Event& b) { return a.exact && b.exact && *a.exact == *b.exact; }

/// Events of a piece that are not told apart.
struct Cluster {
  std::vector<Event> events;
  Rational lower;
  Rational upper;
  /// The one that is known best.
  const Event& best() const {
    const auto rank = [](const Event& x) {
      return x.t.exact() ? 0 : x.exact ? 1 : x.is_fuzzy ? 3 : 2;
    };
    return *std::ranges::min_element(events, {}, rank);
  }
  bool is_fuzzy() const {
    return std::ranges::any_of(events, [](const Event& x) { return x.is_fuzzy; });
  }
};

/// A part that is left, between two classes.
struct Edge {
  OffsetPart part;
  std::size_t from;
  std::size_t to;
  bool is_used = false;
};

class Trimmer {
 public:
  Trimmer(const BoundaryCurves& stroke, const std::string& function)
      : stroke_(stroke),
        function_(function),
        own_(stroke.own),
        series_(std::make_shared<const CurveSeries>(plane_series(stroke_.branches))),
        events_(own_) {}

  TrimmedCurves make() {
    add_ends();
    add_cusps();
    find_parallels();
    add_crossings();
    for (std::size_t k = 0; k < own_; ++k) add_edges(k);
    chain();
    return std::move(result_);
  }

 private:
  void add_event(std::size_t piece, const RealAlgebraic& t, std::size_t place) {
    if (piece < own_)
      events_[piece].push_back({to_real(t), enclose(t, place_bits), place, false, t});
  }
  void add_event(std::size_t piece, Real t, std::size_t place, const Crossing& crossing) {
    if (piece >= own_) return;
    RealBall ball = t.enclose(place_bits);
    std::optional<RealAlgebraic> exact;
    if (t.exact()) exact = *t.exact();
    events_[piece].push_back({std::move(t), std::move(ball), place, false, exact, crossing});
  }
  void add_fuzzy(const CurvePart& part, std::size_t place) {
    if (part.segment >= own_) return;
    const Interval where = interval_of(part);
    const Rational lower = *where.lower;
    const Rational upper = *where.upper;
    events_[part.segment].push_back(
        {Real([lower, upper](long bits) { return hull(lower, upper, bits); }),
         hull(lower, upper, 64), place, true});
  }

  void add_ends() {
    for (std::size_t k = 0; k < own_; ++k) {
      starts_.push_back(classes_.add());
      ends_.push_back(classes_.add());
      add_event(k, Rational(0), starts_[k]);
      add_event(k, Rational(1), ends_[k]);
    }
    for (std::size_t k = 0; k < own_; ++k)
      if (const std::size_t behind = stroke_.branches.behind[k]; behind < own_)
        classes_.join(ends_[k], starts_[behind]);
    for (std::size_t k = 0; k < own_; ++k) {
      join_by_point(k, 0, starts_[k]);
      join_by_point(k, 1, ends_[k]);
    }
  }
  void join_by_point(std::size_t piece, const Rational& t, std::size_t place) {
    if (!stroke_.meet_by_points) return;
    const Vector<Rational> at = point(stroke_.branches.curves[piece], t);
    const std::string name = to_string(at[0]) + " " + to_string(at[1]);
    classes_.join(place, by_point_.emplace(name, place).first->second);
  }

  void add_cusps() {
    for (std::size_t k = 0; k < own_; ++k)
      for (const RealAlgebraic& t : series_->turning[k].reversals) add_event(k, t, classes_.add());
    for (const auto& [piece, t] : stroke_.events) {
      const std::size_t place = classes_.add();
      if (const auto exact = t.rational()) join_by_point(piece, *exact, place);
      add_event(piece, t, place);
    }
  }

  void find_parallels() {
    std::map<std::string, std::size_t> numbers;
    for (const RationalCurve& curve : stroke_.branches.curves) {
      const Vector<Rational> way = point(curve, 1) - point(curve, 0);
      const std::string slope = way[0] == 0 ? "" : to_string(way[1] / way[0]);
      parallels_.push_back(is_line(curve) ? numbers.emplace(slope, numbers.size() + 1).first->second
                                          : 0);
    }
  }

  /// Are they parallel lines?
  bool are_parallel(std::size_t a, std::size_t b) const {
    return parallels_[a] != 0 && parallels_[a] == parallels_[b];
  }

  /// The ends of parts that coincide, which are one point each.
  void add_coincidences() {
    for (const CoincidentParts& x : coincident_)
      for (const auto& [s, t] :
           {std::pair(x.first_from, x.second_from), std::pair(x.first_to, x.second_to)}) {
        const std::size_t place = classes_.add();
        add_event(x.first_segment, s, place);
        add_event(x.second_segment, t, place);
      }
  }

  /// Are there coordinates of which boxes of doubles tell nothing?
  bool is_beyond_doubles() const {
    const Rational most = power_of_ten(300);
    return std::ranges::any_of(stroke_.branches.curves, [&](const RationalCurve& curve) {
      const Vector<Rational> start = point(curve, 0);
      return abs(start[0]) > most || abs(start[1]) > most;
    });
  }

  void add_crossings() {
    CrossingQuery query;
    query.is_idle = [&](const CurveNode& node) {
      return stroke_.covers(turned(node.box)) || is_folded(node);
    };
    query.is_idle_beyond_reversals = !stroke_.signs.empty();
    query.are_idle = [&](const CurveNode& a, const CurveNode& b) {
      if (a.first_segment >= own_ && b.first_segment >= own_) return true;
      if (!a.is_arc() || !b.is_arc()) return false;
      if (are_parallel(a.first_segment, b.first_segment)) return true;
      if (stroke_.are_apart && (a.first_segment < own_) != (b.first_segment < own_) &&
          (a.first_segment < own_ ? stroke_.are_apart(a, b) : stroke_.are_apart(b, a)))
        return true;
      return false;
    };
    if (stroke_.is_covered_beside)
      query.is_idle_beside = [&](const CurveNode& a, const CurveNode& b) {
        return stroke_.is_covered_beside(part_of(a), part_of(b));
      };
    SelfIntersections found = self_intersections(stroke_.branches, *series_, query);
    coincident_ = std::move(found.coincident);
    add_coincidences();
    if (found.is_cut_off)
      throw Undecided(function_ + (is_beyond_doubles()
                                       ? ": of points beyond 10^300 it is not told where they are"
                                       : ": branches touch at too many places"));
    std::vector<Crossing> again;  // told of an earlier piece on the same way, too
    for (const Crossing& x : found.found) {
      if (are_parallel(x.first_segment, x.second_segment)) continue;  // their ends are events
      if (is_repeated(x.first_segment, x.first_t) || is_repeated(x.second_segment, x.second_t))
        continue;
      if (twin(x.first_segment, x.first_t) || twin(x.second_segment, x.second_t)) {
        again.push_back(x);
        continue;
      }
      const std::size_t place = classes_.add();
      const auto [s, t] = parameters(x);
      add_event(x.first_segment, s, place, x);
      add_event(x.second_segment, t, place, x);
    }
    for (const Crossing& x : again) add_again(x);
    for (const KnownMeeting& x : found.touching) {
      const std::size_t place = classes_.add();
      add_event(x.first_segment, x.first_t, place);
      add_event(x.second_segment, x.second_t, place);
    }
    for (const auto& [first, second] : found.undecided) {
      const std::size_t place = classes_.add();
      add_touching(first, second, place);
      add_touching(second, first, place);
    }
  }

  /// Is what happens there told of an earlier piece that it coincides with?
  bool is_repeated(std::size_t piece, const RealBall& t) const {
    return std::ranges::any_of(coincident_, [&](const CoincidentParts& x) {
      return x.second_segment == piece && (x.is_alike || piece >= own_) &&
             is_in_second(x, t.lower(), t.upper());
    });
  }

  /// The earlier piece that it coincides with there, going the other way.
  std::optional<std::size_t> twin(std::size_t piece, const RealBall& t) const {
    for (const CoincidentParts& x : coincident_)
      if (x.second_segment == piece && x.first_segment != piece &&
          is_in_second(x, t.lower(), t.upper()))
        return x.first_segment;
    return std::nullopt;
  }

  /// A crossing with the second one of two pieces that coincide. On the piece that crosses both it
  /// is the place where that crosses the first one, which is an event already.
  void add_again(const Crossing& x) {
    const auto [s, t] = parameters(x);
    const bool is_first = twin(x.first_segment, x.first_t).has_value();
    const std::size_t piece = is_first ? x.first_segment : x.second_segment;
    const std::size_t across = is_first ? x.second_segment : x.first_segment;
    const std::size_t earlier = *twin(piece, is_first ? x.first_t : x.second_t);
    const Real& at = is_first ? s : t;
    const Real& at_across = is_first ? t : s;
    const auto is_there = [&](const Event& event) {
      return event.crossing && event.ball.overlaps(at_across.enclose(place_bits)) &&
             (event.crossing->first_segment == earlier ||
              event.crossing->second_segment == earlier);
    };
    if (across < own_)
      if (const auto found = std::ranges::find_if(events_[across], is_there);
          found != events_[across].end())
        return add_event(piece, at, found->place, x);
    const std::size_t place = classes_.add();
    add_event(piece, at, place, x);
    add_event(across, at_across, place, x);
  }

  bool is_folded(const CurveNode& node) const {
    if (!node.is_arc()) return false;
    if (stroke_.is_folded) return stroke_.is_folded(part_of(node));
    return !stroke_.signs.empty() && node.reversals == 0 &&
           node.first_sign == -stroke_.signs[node.first_segment];
  }

  /// Where lines and circles are touched is decided by algebra.
  void add_touching(const CurvePart& part, const CurvePart& other, std::size_t place) {
    const auto& curves = stroke_.branches.curves;
    if (part.segment >= own_) return;
    const auto found =
        meetings(curves[part.segment], part, curves[other.segment], stroke_.centers[other.segment]);
    if (!found) return add_fuzzy(part, place);
    for (const RealAlgebraic& t : *found)
      add_event(part.segment, t, found->size() == 1 ? place : classes_.add());
  }

  static CurvePart part_of(const CurveNode& arc) {
    return {arc.first_segment, arc.lower, arc.upper};
  }

  /// The tree looks along z, from where x is the second axis and −y the first one.
  static PlaneBox turned(const PlaneBox& box) {
    return {box[1], DoubleInterval{-box[0].upper, -box[0].lower}};
  }

  std::pair<Real, Real> parameters(const Crossing& x) const {
    const RationalCurve& a = stroke_.branches.curves[x.first_segment];
    const RationalCurve& b = stroke_.branches.curves[x.second_segment];
    if (is_line(a) && is_line(b)) return {Real(share_up_to(a, b)), Real(share_up_to(b, a))};
    // Rational often.
    const auto found = narrowed(*series_, x, 2 * place_bits);
    const Rational p = simplest_between(found.first.lower(), found.first.upper());
    const Rational q = simplest_between(found.second.lower(), found.second.upper());
    if (bits_of(p) + bits_of(q) < 2 * place_bits && point(a, p) == point(b, q))
      return {Real(p), Real(q)};
    const auto real = [&](bool is_first) {
      Crossing near = x;
      near.first_t = found.first;
      near.second_t = found.second;
      return cached(Real(Real::Enclosure([series = series_, near, is_first](long bits) {
        const auto both = narrowed(*series, near, bits);
        return is_first ? both.first : both.second;
      })));
    };
    return {real(true), real(false)};
  }

  /// Is a crossing of the piece at a place that is known exactly?
  void identify(std::size_t piece, Event& event, const Event& known) const {
    if (!event.crossing || event.exact || !known.exact) return;
    const Crossing& x = *event.crossing;
    const bool is_first = piece == x.first_segment && x.first_t.overlaps(known.ball);
    const auto& curves = stroke_.branches.curves;
    const RealBall& t = is_first ? x.second_t : x.first_t;
    if (passes_through(curves[is_first ? x.second_segment : x.first_segment],
                       closed_interval(t.lower(), t.upper()), curves[piece], *known.exact))
      event.exact = known.exact;
  }

  /// Finds the place of a crossing exactly, where it is not known.
  void make_exact(std::size_t piece, Event& event) const {
    if (!event.crossing || event.exact) return;
    const Crossing& x = *event.crossing;
    const bool is_first = piece == x.first_segment && x.first_t.overlaps(event.ball);
    const auto& curves = stroke_.branches.curves;
    event.exact = exact_place(curves[piece], curves[is_first ? x.second_segment : x.first_segment],
                              event.ball);
  }

  /// By places; those that are not told apart are looked at with more bits, once.
  void sort(std::size_t piece, std::vector<Event>& events) const {
    const auto lower = [](const Event& x) { return x.ball.lower(); };
    std::ranges::sort(events, {}, lower);
    for (std::size_t k = 0; k + 1 < events.size(); ++k) {
      Event& a = events[k];
      Event& b = events[k + 1];
      if (a.is_fuzzy || b.is_fuzzy || are_same(a, b) || !a.ball.overlaps(b.ball)) continue;
      a.ball = a.t.enclose(closest_place_bits);
      b.ball = b.t.enclose(closest_place_bits);
      if (!a.ball.overlaps(b.ball)) continue;
      if (!a.exact && !b.exact) make_exact(piece, a);
      identify(piece, a, b);
      identify(piece, b, a);
    }
    std::ranges::sort(events, {}, lower);
  }

  std::vector<Cluster> clusters(std::size_t piece) {
    std::vector<Event>& events = events_[piece];
    sort(piece, events);
    std::vector<Cluster> found;
    for (Event& x : events) {
      const Rational lower = x.ball.lower();
      const Rational upper = x.ball.upper();
      if (found.empty() || lower > found.back().upper) {
        found.push_back({{std::move(x)}, lower, upper});
        continue;
      }
      classes_.join(found.back().events.front().place, x.place);
      found.back().upper = std::max(found.back().upper, upper);
      found.back().events.push_back(std::move(x));
    }
    return found;
  }

  /// Is it on an earlier piece, too, with H the same way? Of what is there twice one is left.
  bool is_doubled(std::size_t piece, const Rational& t) const {
    return std::ranges::any_of(coincident_, [&](const CoincidentParts& x) {
      return x.is_alike && x.second_segment == piece && is_in_second(x, t, t);
    });
  }
  static bool is_in_second(const CoincidentParts& x, const Rational& lower, const Rational& upper) {
    const auto& [from, to] = std::minmax(x.second_from, x.second_to);
    return compare(from, lower) < 0 && compare(to, upper) > 0;
  }

  void add_edges(std::size_t piece) {
    const std::vector<Cluster> places = clusters(piece);
    std::vector<bool> left;
    std::vector<bool> backward;
    for (std::size_t k = 0; k + 1 < places.size(); ++k) {
      const Rational quarter = (places[k + 1].lower - places[k].upper) / 4;
      const Rational sample =
          simplest_between(places[k].upper + quarter, places[k + 1].lower - quarter);
      left.push_back(!stroke_.is_cut(piece, sample) && !is_doubled(piece, sample));
      backward.push_back(stroke_.is_backward && stroke_.is_backward(piece, sample));
    }
    std::optional<std::size_t> from;
    for (std::size_t k = 0; k < places.size(); ++k) {
      const bool before = k > 0 && left[k - 1];
      const bool after = k < left.size() && left[k];
      if (before == after && k > 0 && k < left.size() && backward[k - 1] == backward[k]) {
        add_undecided(piece, places[k], before);
        continue;
      }
      if (before && backward[k - 1])
        add_edge(piece, places[k], places[*from]);
      else if (before)
        add_edge(piece, places[*from], places[k]);
      if (after) from = k;
    }
  }

  void add_edge(std::size_t piece, const Cluster& from, const Cluster& to) {
    for (const Cluster* end : {&from, &to})
      if (end->best().is_fuzzy) result_.undecided.push_back({piece, end->best().ball});
    edges_.push_back(
        {{piece, from.best().t, to.best().t}, from.events.front().place, to.events.front().place});
  }

  /// Of what is alike on both sides.
  void add_undecided(std::size_t piece, const Cluster& cluster, bool is_left) {
    const auto& events = cluster.events;
    const bool is_one = std::ranges::all_of(
        events, [&](const Event& x) { return !x.is_fuzzy && are_same(x, events.front()); });
    if (!cluster.is_fuzzy() && (is_left || is_one || events.size() == 1)) return;
    if (is_doubled(piece, cluster.lower) && is_doubled(piece, cluster.upper)) return;
    if (!is_left && stroke_.is_covered(piece, cluster.lower, cluster.upper)) return;
    result_.undecided.push_back({piece, hull(cluster.lower, cluster.upper, place_bits)});
  }

  /// Each edge is in one branch; those that begin where no other one ends are first.
  void chain() {
    std::multimap<std::size_t, std::size_t> starting;
    std::map<std::size_t, long> surplus;
    for (std::size_t k = 0; k < edges_.size(); ++k) {
      Edge& edge = edges_[k];
      edge.from = classes_.of(edge.from);
      edge.to = classes_.of(edge.to);
      starting.emplace(edge.from, k);
      ++surplus[edge.from];
      --surplus[edge.to];
    }
    for (std::size_t k = 0; k < edges_.size(); ++k)
      if (!edges_[k].is_used && surplus[edges_[k].from] > 0) {
        --surplus[edges_[k].from];
        follow(k, starting);
      }
    for (std::size_t k = 0; k < edges_.size(); ++k)
      if (!edges_[k].is_used) follow(k, starting);
    std::ranges::stable_sort(result_.branches, {}, [](const TrimmedBranch& branch) {
      const OffsetPart& first = branch.parts.front();
      return std::pair(first.piece, first.from.enclose(place_bits).midpoint());
    });
  }

  void follow(std::size_t first, const std::multimap<std::size_t, std::size_t>& starting) {
    TrimmedBranch branch{{}, false};
    std::optional<std::size_t> next = first;
    while (next) {
      Edge& edge = edges_[*next];
      edge.is_used = true;
      branch.parts.push_back(edge.part);
      branch.is_closed = edge.to == edges_[first].from;
      next.reset();
      if (branch.is_closed) break;
      const auto [begin, end] = starting.equal_range(edge.to);
      const auto unused =
          std::find_if(begin, end, [&](const auto& x) { return !edges_[x.second].is_used; });
      if (unused != end) next = unused->second;
    }
    result_.branches.push_back(std::move(branch));
  }

  const BoundaryCurves& stroke_;
  const std::string& function_;
  TrimmedCurves result_;
  std::size_t own_;
  std::shared_ptr<const CurveSeries> series_;
  std::vector<std::vector<Event>> events_;
  std::map<std::string, std::size_t> by_point_;
  std::vector<std::size_t> starts_;
  std::vector<std::size_t> ends_;
  Classes classes_;
  std::vector<std::size_t> parallels_;  ///< one number for lines that are parallel, 0 for others
  std::vector<CoincidentParts> coincident_;
  std::vector<Edge> edges_;
};

}  // namespace

bool is_line(const RationalCurve& curve) {
  return degree(curve) == 1 && curve.weight().is_constant();
}

TrimmedCurves trimmed(const BoundaryCurves& curves, const std::string& function) {
  return Trimmer(curves, function).make();
}

}  // namespace phrame
