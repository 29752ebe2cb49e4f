// All points at the distance |d| from the path are on its boundary curves: the offsets to both
// sides, the arcs about corners on their outer sides, and half-circles about the ends of an open
// path. Along an offset the distance from the path is at most |d|, and where it changes from |d| to
// less, at a point Q, there are points of the path as near to Q as |d| beside the one that Q
// belongs to, so that another boundary curve goes through Q; or that one is next to it, and 1 + dκ
// changes its sign. So between two such places one point tells for all. A part of which one point
// of the path is seen to be nearer than |d| has no such place.
//
// With mitres, what is between them and the path counts as nearer, too: kites, of which two sides
// are mitres, which are boundary curves in place of the arcs, and two are at less than |d| from the
// corner.
//
// Branches that coincide are lines, circles about one corner, or the same curve. One does not cross
// the other, as parallel lines do not, and the ends of each cut the other one.
#include "phrame/ph/offset/offset_trim.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>
#include <set>

#include "phrame/algebra/error.hpp"
#include "phrame/ph/curve/close_crossings.hpp"
#include "phrame/ph/curve/special_points.hpp"
#include "phrame/ph/curve/transform.hpp"
#include "phrame/ph/curve/vector.hpp"
#include "phrame/ph/offset/offset_meeting.hpp"
#include "phrame/ph/offset/path_distance.hpp"
#include "phrame/ph/offset/plane_tangent.hpp"
#include "phrame/ph/offset/shadow.hpp"
#include "phrame/ph/offset/turning_parts.hpp"

namespace phrame::inline v0 {
namespace {

constexpr long place_bits = 320;

void require_no_turning_back(const PhPath& path) {
  for (std::size_t k = 0; k < path.segments().size(); ++k) {
    const auto turns = odd_inside(cusps(path.segments()[k]));
    if (!turns.empty())
      throw DomainError(
          fmt::format("trimmed_offset: the path turns back at a cusp, in segment {} at {}", k + 1,
                      place_text("t", turns.front().at)));
  }
}

/// The boundary curves.
struct Stroke {
  OffsetBranches branches;                               ///< first those of the offset itself
  std::vector<std::optional<Vector<Rational>>> centers;  ///< of the arcs
  std::vector<Vector<Polynomial>> bases;  ///< what they are at the distance |d| from, at the same t
};

Vector<Polynomial> constant(const Vector<Rational>& at) {
  return {Polynomial{at[0]}, Polynomial{at[1]}, Polynomial{at[2]}};
}

bool is_line(const RationalCurve& curve) {
  return degree(curve) == 1 && curve.weight().is_constant();
}

class StrokeMaker {
 public:
  StrokeMaker(const PhPath& path, const Offset& offset) : path_(path), offset_(offset) {}

  Stroke make() {
    const auto& segments = path_.segments();
    add(offset_, path_);
    if (path_.closing_turn()) {
      add(phrame::offset(path_, -offset_.distance), path_);
      return std::move(stroke_);
    }
    const PhPath back = *reversed(Path(path_)).ph();
    const Curve& last = segments.back();
    add_cap(evaluate(position(last), 1), direction(plane_tangent(last), 1));
    add(phrame::offset(back, offset_.distance), back);
    const PlaneVector start = direction(plane_tangent(segments.front()), 0);
    add_cap(segments.front().start(), {-start.x, -start.y});
    stroke_.branches.behind.back() = 0;
    return std::move(stroke_);
  }

 private:
  /// What is behind an open end is what is added next.
  void add(const Offset& offset, const PhPath& path) {
    const std::size_t first = stroke_.branches.curves.size();
    const OffsetBranches more = branches_of(offset);
    for (std::size_t k = 0; k < more.curves.size(); ++k) {
      stroke_.branches.curves.push_back(more.curves[k]);
      const std::size_t behind = more.behind[k];
      stroke_.branches.behind.push_back(behind == no_segment ? no_segment : first + behind);
      const OffsetPiece& piece = offset.pieces[k];
      const Curve& base = path.segments()[piece.segment];
      const bool is_arc = piece.is_join && !is_line(piece.curve);
      stroke_.centers.push_back(is_arc ? std::optional(base.start()) : std::nullopt);
      stroke_.bases.push_back(piece.is_join ? constant(base.start()) : position(base));
    }
    if (!path.closing_turn()) stroke_.branches.behind.back() = stroke_.branches.curves.size();
  }

  void add_cap(const Vector<Rational>& at, const PlaneVector& e1) {
    for (RationalCurve& curve : end_cap(at, e1, offset_.distance)) {
      stroke_.branches.curves.push_back(std::move(curve));
      stroke_.branches.behind.push_back(stroke_.branches.curves.size());
      stroke_.centers.emplace_back(at);
      stroke_.bases.push_back(constant(at));
    }
  }

  const PhPath& path_;
  const Offset& offset_;
  Stroke stroke_;
};

/// "x, y" that tell a line, a circle or a curve from others that it does not coincide with.
std::string carrier_of(const RationalCurve& curve, const std::optional<Vector<Rational>>& center) {
  if (center) return fmt::format("circle {} {}", to_string((*center)[0]), to_string((*center)[1]));
  const Vector<Rational> from = point(curve, 0);
  const Vector<Rational> to = point(curve, 1);
  if (is_line(curve)) {
    // a·x + b·y = c, of which the first coefficient that is not 0 is 1.
    Rational a = from[1] - to[1];
    Rational b = to[0] - from[0];
    Rational c = a * from[0] + b * from[1];
    const Rational unit = a != 0 ? a : b;
    return fmt::format("line {} {} {}", to_string(a / unit), to_string(b / unit),
                       to_string(c / unit));
  }
  std::array<std::string, 3> names{to_string(from[0]) + " " + to_string(from[1]),
                                   to_string(to[0]) + " " + to_string(to[1])};
  std::sort(names.begin(), names.begin() + 2);
  const Vector<Rational> middle = point(curve, Rational(1, 2));
  return fmt::format("curve {} {} {} {}", names[0], names[1], to_string(middle[0]),
                     to_string(middle[1]));
}

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

/// What is between the mitres of an offset and the path: kites with the corner, the tip, and the
/// ends of the offsets of both sides.
class MitreKites {
 public:
  MitreKites(const PhPath& path, const Offset& offset) {
    const auto& pieces = offset.pieces;
    for (std::size_t k = 0; k + 1 < pieces.size(); ++k) {
      if (!pieces[k].is_join || !is_line(pieces[k].curve)) continue;
      const Vector<Rational>& corner = path.segments()[pieces[k].segment].start();
      Kite kite{{corner, point(pieces[k].curve, 0), point(pieces[k].curve, 1),
                 point(pieces[k + 1].curve, 1)}};
      if (side(kite.points[0], kite.points[1], kite.points[2]) < 0)
        std::swap(kite.points[1], kite.points[3]);
      const Vector<Rational> reach = kite.points[2] - corner;
      kite.center = {round_to_double(corner[0]), round_to_double(corner[1])};
      kite.reach = 1.001 * round_to_double(abs(reach[0]) + abs(reach[1])) +
                   1e-12 * (std::abs(kite.center[0]) + std::abs(kite.center[1]));
      kites_.push_back(std::move(kite));
      ++k;
    }
  }

  /// Is the point inside one of them, not on its boundary?
  bool contain(const Vector<Rational>& at) const {
    const double x = round_to_double(at[0]);
    const double y = round_to_double(at[1]);
    return std::ranges::any_of(kites_, [&](const Kite& kite) {
      if (std::abs(x - kite.center[0]) > kite.reach || std::abs(y - kite.center[1]) > kite.reach)
        return false;
      for (std::size_t k = 0; k < 4; ++k)
        if (side(kite.points[k], kite.points[(k + 1) % 4], at) <= 0) return false;
      return true;
    });
  }

 private:
  struct Kite {
    std::array<Vector<Rational>, 4> points;  ///< to the left
    std::array<double, 2> center{};          ///< the corner
    double reach = 0;                        ///< nothing of it is farther from that, in x and in y
  };

  /// 1 where c is to the left of the line from a to b.
  static int side(const Vector<Rational>& a, const Vector<Rational>& b, const Vector<Rational>& c) {
    return Rational((b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0])).sign();
  }

  std::vector<Kite> kites_;
};

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
  RealBall ball;          ///< around t
  std::size_t place;      ///< a class: one point of the plane
  bool is_fuzzy = false;  ///< may it be none, or several?
};

/// Events of a piece that are not told apart.
struct Cluster {
  std::vector<Event> events;
  Rational lower;
  Rational upper;
  /// The one that is known best.
  const Event& best() const {
    const auto rank = [](const Event& x) { return x.t.exact() ? 0 : x.is_fuzzy ? 2 : 1; };
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
  Trimmer(const PhPath& path, const Rational& d, OffsetJoin join)
      : path_(path),
        result_{phrame::offset(path, d, join), {}, {}},
        own_(result_.offset.pieces.size()),
        stroke_(StrokeMaker(path, result_.offset).make()),
        series_(std::make_shared<const CurveSeries>(
            plane_series(stroke_.branches.curves, stroke_.branches.behind))),
        distance_(path, d),
        kites_(path, result_.offset),
        events_(own_) {}

  TrimmedOffset make() {
    add_ends();
    add_cusps();
    find_parallels();
    find_coincidences();
    add_crossings();
    for (std::size_t k = 0; k < own_; ++k) add_edges(k);
    chain();
    return std::move(result_);
  }

 private:
  void add_event(std::size_t piece, Real t, std::size_t place) {
    if (piece >= own_) return;
    RealBall ball = t.enclose(place_bits);
    events_[piece].push_back({std::move(t), std::move(ball), place});
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
  }

  void add_cusps() {
    for (std::size_t k = 0; k < own_; ++k)
      for (const RealAlgebraic& t : series_->turning[k].reversals)
        add_event(k, to_real(t), classes_.add());
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

  void find_coincidences() {
    std::map<std::string, std::vector<std::size_t>> carriers;
    for (std::size_t k = 0; k < stroke_.branches.curves.size(); ++k)
      carriers[carrier_of(stroke_.branches.curves[k], stroke_.centers[k])].push_back(k);
    for (const auto& [name, pieces] : carriers)
      for (const std::size_t a : pieces)
        for (const std::size_t b : pieces)
          if (a != b && coincide(a, b)) add_coincidence(a, b);
  }

  /// Lines and circles do, if they have one name; of other curves it is checked.
  bool coincide(std::size_t a, std::size_t b) const {
    const RationalCurve& p = stroke_.branches.curves[a];
    const RationalCurve& q = stroke_.branches.curves[b];
    if (stroke_.centers[a] || is_line(p)) return true;
    const auto is_same = [&](const Polynomial& t) {
      return std::ranges::all_of(std::array{0U, 1U}, [&](unsigned k) {
        return p.numerator()[k] * compose(q.weight(), t) ==
               compose(q.numerator()[k], t) * p.weight();
      });
    };
    return is_same({0, 1}) || is_same({1, -1});
  }

  void add_coincidence(std::size_t a, std::size_t b) {
    coincident_.insert({a, b});
    if (a >= own_) return;
    for (const long end : {0L, 1L}) {
      const std::size_t place = b >= own_ ? classes_.add() : end == 0 ? starts_[b] : ends_[b];
      for (const RealAlgebraic& t :
           through(stroke_.branches.curves[a], point(stroke_.branches.curves[b], end),
                   open_interval(0, 1)))
        add_event(a, to_real(t), place);
    }
  }

  void add_crossings() {
    CrossingQuery query;
    query.is_idle = [&](const CurveNode& node) { return distance_.covers(turned(node.box)); };
    query.are_idle = [&](const CurveNode& a, const CurveNode& b) {
      if (a.first_segment >= own_ && b.first_segment >= own_) return true;
      if (!a.is_arc() || !b.is_arc()) return false;
      if (are_parallel(a.first_segment, b.first_segment)) return true;
      return coincident_.contains({a.first_segment, b.first_segment});
    };
    query.is_idle_beside = [&](const CurveNode& a, const CurveNode& b) {
      const Interval part = interval_of(part_of(a));
      const Interval beside = interval_of(part_of(b));
      return is_nearer_along(stroke_.branches.curves[a.first_segment], *part.lower, *part.upper,
                             stroke_.bases[b.first_segment], (*beside.lower + *beside.upper) / 2,
                             result_.offset.distance);
    };
    const SelfIntersections found = self_intersections(stroke_.branches, *series_, query);
    if (found.is_cut_off)
      throw Undecided("trimmed_offset: too many branches of the offset touch each other");
    for (const Crossing& x : found.found) {
      if (are_parallel(x.first_segment, x.second_segment)) continue;  // their ends are events
      const std::size_t place = classes_.add();
      const auto [s, t] = parameters(x);
      add_event(x.first_segment, s, place);
      add_event(x.second_segment, t, place);
    }
    for (const auto& [first, second] : found.undecided) {
      const std::size_t place = classes_.add();
      add_touching(first, second, place);
      add_touching(second, first, place);
    }
  }

  /// Where lines and circles are touched is decided by algebra.
  void add_touching(const CurvePart& part, const CurvePart& other, std::size_t place) {
    const auto& curves = stroke_.branches.curves;
    if (part.segment >= own_ || coincident_.contains({part.segment, other.segment})) return;
    const auto found =
        meetings(curves[part.segment], part, curves[other.segment], stroke_.centers[other.segment]);
    if (!found) return add_fuzzy(part, place);
    for (const RealAlgebraic& t : *found)
      add_event(part.segment, to_real(t), found->size() == 1 ? place : classes_.add());
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

  std::vector<Cluster> clusters(std::size_t piece) {
    std::vector<Event>& events = events_[piece];
    std::ranges::sort(events, {}, [](const Event& x) { return x.ball.lower(); });
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

  /// A point of the path that is nearer than |d|.
  std::optional<Vector<Rational>> nearer_point(std::size_t piece, const Rational& t) const {
    const OffsetPiece& of = result_.offset.pieces[piece];
    const Vector<Rational> at = point(of.curve, t);
    return of.is_join ? distance_.nearer_point(at) : distance_.nearer_point(at, of.segment, t);
  }

  /// Is it on an earlier line, too, that goes the same way? Of mitres that shut a neck one is left.
  bool is_doubled(std::size_t piece, const Rational& t) const {
    const RationalCurve& curve = stroke_.branches.curves[piece];
    if (!is_line(curve)) return false;
    const Vector<Rational> at = point(curve, t);
    const Vector<Rational> way = point(curve, 1) - point(curve, 0);
    for (auto pair = coincident_.lower_bound({piece, 0});
         pair != coincident_.end() && pair->first == piece && pair->second < piece; ++pair) {
      const RationalCurve& other = stroke_.branches.curves[pair->second];
      const Rational start = dot(way, point(other, 0));
      const Rational end = dot(way, point(other, 1));
      const Rational here = dot(way, at);
      if (start < here && here < end) return true;
    }
    return false;
  }

  void add_edges(std::size_t piece) {
    const std::vector<Cluster> places = clusters(piece);
    std::vector<bool> left;
    for (std::size_t k = 0; k + 1 < places.size(); ++k) {
      const Rational quarter = (places[k + 1].lower - places[k].upper) / 4;
      const Rational sample =
          simplest_between(places[k].upper + quarter, places[k + 1].lower - quarter);
      left.push_back(!nearer_point(piece, sample) &&
                     !kites_.contain(point(result_.offset.pieces[piece].curve, sample)) &&
                     !is_doubled(piece, sample));
    }
    std::optional<std::size_t> from;
    for (std::size_t k = 0; k < places.size(); ++k) {
      const bool before = k > 0 && left[k - 1];
      const bool after = k < left.size() && left[k];
      if (before == after && k > 0 && k < left.size()) {
        add_undecided(piece, places[k], before);
        continue;
      }
      if (before) add_edge(piece, places[*from], places[k]);
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
    const bool is_one = std::ranges::all_of(events, [&](const Event& x) {
      return !x.is_fuzzy && x.t.exact() && x.t.exact() == events.front().t.exact();
    });
    if (!cluster.is_fuzzy() && (is_left || is_one || events.size() == 1)) return;
    if (!is_left && is_covered(piece, cluster)) return;
    result_.undecided.push_back({piece, hull(cluster.lower, cluster.upper, place_bits)});
  }

  /// Is all of it seen to be nearer than |d| to one point of the path?
  bool is_covered(std::size_t piece, const Cluster& cluster) const {
    const auto at = nearer_point(piece, (cluster.lower + cluster.upper) / 2);
    return at && is_nearer_along(stroke_.branches.curves[piece], cluster.lower, cluster.upper,
                                 constant(*at), 0, result_.offset.distance);
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
      return branch.parts.front().piece;
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

  const PhPath& path_;
  TrimmedOffset result_;
  std::size_t own_;
  Stroke stroke_;
  std::shared_ptr<const CurveSeries> series_;
  PathDistance distance_;
  MitreKites kites_;
  std::vector<std::vector<Event>> events_;
  std::vector<std::size_t> starts_;
  std::vector<std::size_t> ends_;
  Classes classes_;
  std::vector<std::size_t> parallels_;  ///< one number for lines that are parallel, 0 for others
  std::set<std::pair<std::size_t, std::size_t>> coincident_;
  std::vector<Edge> edges_;
};

/// Of the offset of a path in parts, as that of the path: what goes on through a cut is one part.
class Reunion {
 public:
  Reunion(const TrimmedOffset& found, const std::vector<SegmentPart>& parts, Offset whole)
      : found_(found), result_{std::move(whole), {}, {}} {
    std::size_t piece = 0;
    for (const OffsetPiece& x : found.offset.pieces) {
      if (x.is_join) {
        origins_.push_back({piece++, 0, 1});
        continue;
      }
      const SegmentPart& part = parts[x.segment];
      origins_.push_back({piece, part.lower, part.upper});
      if (part.upper == 1) ++piece;
    }
  }

  TrimmedOffset make() {
    for (const TrimmedBranch& branch : found_.branches) result_.branches.push_back(whole(branch));
    for (const UndecidedStretch& x : found_.undecided) {
      const SegmentPart& of = origins_[x.piece];
      constexpr long bits = 320;
      result_.undecided.push_back(
          {of.segment, add(RealBall(of.lower, bits),
                           multiply(RealBall(of.upper - of.lower, bits), x.t, bits), bits)});
    }
    return std::move(result_);
  }

 private:
  OffsetPart whole(const OffsetPart& part) const {
    const auto& [piece, lower, upper] = origins_[part.piece];
    if (lower == 0 && upper == 1) return {piece, part.from, part.to};
    const auto along = [&from = lower, width = upper - lower](const Real& t) {
      return cached(Real(from) + Real(width) * t);
    };
    return {piece, along(part.from), along(part.to)};
  }

  static bool goes_on(const OffsetPart& a, const OffsetPart& b) {
    return a.piece == b.piece && a.to.exact() && a.to.exact() == b.from.exact();
  }

  TrimmedBranch whole(const TrimmedBranch& branch) const {
    TrimmedBranch made{{}, branch.is_closed};
    for (const OffsetPart& fine : branch.parts) {
      OffsetPart part = whole(fine);
      if (made.parts.empty() || !goes_on(made.parts.back(), part))
        made.parts.push_back(std::move(part));
      else
        made.parts.back().to = std::move(part.to);
    }
    if (made.is_closed && made.parts.size() > 1 && goes_on(made.parts.back(), made.parts.front())) {
      made.parts.front().from = made.parts.back().from;
      made.parts.pop_back();
    }
    return made;
  }

  const TrimmedOffset& found_;
  TrimmedOffset result_;
  std::vector<SegmentPart> origins_;  ///< what the pieces are of those of the whole offset
};

/// Without the joins.
std::vector<TrimmedBranch> opened(const TrimmedOffset& trimmed) {
  std::vector<TrimmedBranch> found;
  for (const TrimmedBranch& branch : trimmed.branches) {
    const auto is_join = [&](const OffsetPart& part) {
      return trimmed.offset.pieces[part.piece].is_join;
    };
    std::vector<OffsetPart> parts = branch.parts;
    const auto first = std::ranges::find_if(parts, is_join);
    const bool is_cut = first != parts.end();
    if (branch.is_closed) std::rotate(parts.begin(), first, parts.end());
    TrimmedBranch open{{}, branch.is_closed && !is_cut};
    for (const OffsetPart& part : parts) {
      if (!is_join(part)) open.parts.push_back(part);
      if (is_join(part) && !open.parts.empty()) found.push_back(std::exchange(open, {{}, false}));
    }
    if (!open.parts.empty()) found.push_back(std::move(open));
  }
  return found;
}

}  // namespace

TrimmedOffset trimmed_offset(const PhPath& path, const Rational& d, OffsetJoin join) {
  require_no_turning_back(path);
  const OffsetJoin trimmed = join == OffsetJoin::mitre ? join : OffsetJoin::round;
  Offset whole = phrame::offset(path, d, trimmed);
  const PathInParts fine = in_turning_parts(path);
  const TrimmedOffset found = Trimmer(fine.path, d, trimmed).make();
  TrimmedOffset result = Reunion(found, fine.parts, std::move(whole)).make();
  if (join == OffsetJoin::open) result.branches = opened(result);
  return result;
}

}  // namespace phrame
