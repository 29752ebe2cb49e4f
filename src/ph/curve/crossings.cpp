#include "phrame/ph/curve/crossings.hpp"

#include <algorithm>
#include <cmath>

#include "phrame/algebra/ball_order.hpp"
#include "phrame/ph/curve/close_crossings.hpp"
#include "phrame/ph/curve/curve_arc.hpp"

// P is the projected curve. An arc on which P′ stays within a half-plane, d·P′ > 0, does not cross
// itself; so do two successive ones with one d, and with P′(s) × P′(t) ≠ 0, as at a corner: two
// points in common would be the ends of parallel chords. Two arcs whose boxes are apart do not
// cross; nor do those that are apart across one of them. Where P′(s) × P′(t) ≠ 0 on two arcs, P(s)
// − P(t) = 0 has one solution there at most, and Newton's step N from the middle, with the
// derivatives of the whole arcs, holds it: it is there if N is inside, and not if N is outside.
// Else the longer arc is halved. What becomes too short ends the search of crossings, for which
// another projection may do better, and is told as undecided of a curve that is in a plane.

namespace phrame::inline v0 {
namespace {

constexpr long crossing_bits = 96;
constexpr long most_crossing_bits = 5000;
constexpr double least_arc = 0x1p-30;
constexpr long most_pairs = 4'000'000;
constexpr double least_plane_arc = 0x1p-24;
constexpr long most_plane_pairs = 400'000;  // and as many for ten segments each
constexpr long most_close_failures = 8;
constexpr std::size_t most_undecided = 64;  // and eight for each segment

/// Is the arc so short that the errors of doubles tell nothing more of it?
bool is_tiny(const PlaneBox& box) {
  constexpr double least = 0x1p-42;
  return std::ranges::all_of(box, [](const DoubleInterval& x) {
    return x.upper - x.lower < least * std::max(std::abs(x.lower), std::abs(x.upper));
  });
}

std::pair<RealBall, RealBall> ends_of(const CurveNode& arc) {
  return {exact_sum(arc.lower, 0), exact_sum(arc.upper, 0)};
}

bool is_outside(const RealBall& t, const CurveNode& arc) {
  const auto [lower, upper] = ends_of(arc);
  return is_less(t, lower) || is_less(upper, t);
}

/// Is it inside of the arc, and of a ball?
bool is_inside(const RealBall& t, const RealBall& ball, const CurveNode& arc) {
  const auto [lower, upper] = ends_of(arc);
  return is_less(lower, t) && is_less(t, upper) && ball.contains(t.lower()) &&
         ball.contains(t.upper());
}

/// What is in both, and in the arc; that in the ball where t is not finite.
RealBall common_of(const RealBall& t, const RealBall& ball, const CurveNode& arc, long bits) {
  if (!t.is_finite()) return ball;
  const auto [lower, upper] = ends_of(arc);
  return hull(std::max({t.lower(), ball.lower(), lower.midpoint()}),
              std::min({t.upper(), ball.upper(), upper.midpoint()}), 2 * bits);
}

/// An e with 2^e above the radii of both.
long exponent_of_width(const RealBall& s, const RealBall& t) {
  return std::max(exponent_above(radius_of(s)), exponent_above(radius_of(t)));
}

CurvePart part_of(const CurveNode& arc) { return {arc.first_segment, arc.lower, arc.upper}; }

/// The t of an arc that are in a ball.
CurvePart part_of(const CurveNode& arc, const RealBall& t) {
  return {arc.first_segment, std::max(arc.lower, -upper_double(subtract({}, t, crossing_bits))),
          std::min(arc.upper, upper_double(t))};
}

class CrossingSearch {
 public:
  CrossingSearch(CurveTree& first, CurveTree& second) : first_(first), second_(second) {}
  /// Of a curve in a plane, with itself.
  CrossingSearch(CurveTree& plane, const CrossingQuery& query, CloseSearch& close)
      : first_(plane),
        second_(plane),
        close_(&close),
        most_pairs_(most_plane_pairs +
                    most_plane_pairs / 10 * static_cast<long>(plane.root().last_segment)),
        query_(query) {}

  std::optional<std::vector<Crossing>> with_itself() {
    return visit_self(first_.root()) ? std::optional(std::move(found_)) : std::nullopt;
  }
  std::optional<std::vector<Crossing>> with_other() {
    return visit_pair(first_.root(), second_.root()) ? std::optional(std::move(found_))
                                                     : std::nullopt;
  }
  SelfIntersections in_plane();

 private:
  bool is_same_curve() const { return &first_ == &second_; }
  bool is_plane() const { return close_ != nullptr; }

  /// All in a node with itself; false where that is not decided.
  bool visit_self(CurveNode& node) {
    if (is_idle(node) || first_.is_simple(node, query_.is_idle_beyond_reversals)) return true;
    if (node.is_arc() && query_.are_idle && query_.are_idle(node, node)) return true;
    if (!is_left()) return false;
    if (is_too_short(node)) return leave_undecided({part_of(node), part_of(node)});
    first_.split(node);
    return visit_self(*node.halves[0]) && visit_self(*node.halves[1]) &&
           visit_pair(*node.halves[0], *node.halves[1]);
  }

  bool visit_pair(CurveNode& a, CurveNode& b) {
    if (!is_left()) return false;
    if (are_apart(a.box, b.box) || is_idle(a) || is_idle(b)) return true;
    if (query_.are_idle && query_.are_idle(a, b)) return true;
    const bool are_neighbours = is_same_curve() && first_.share_end(a, b);
    if (are_neighbours && first_.are_simple(a, b, query_.is_idle_beyond_reversals)) return true;
    if (is_same_curve() && first_.are_on_one_way(a, b)) return true;
    if (!are_neighbours && a.is_arc() && b.is_arc()) {
      if (are_apart_across(a, b)) return true;
      if (are_transversal(a.velocity, b.velocity)) {
        const auto [is_decided, crossing, place] = solve(a, b);
        if (crossing) return add_crossing(a, b, *crossing);
        if (is_decided || is_known(a, b)) return true;
        if (place) return leave_undecided(*place);
      }
      if (query_.has_near_cusps && are_nearly_parallel(a, b) && are_told_closely(a, b)) return true;
      if (is_plane() && is_tiny(a.box) && is_tiny(b.box))
        return add_undecided({part_of(a), part_of(b)});
    }
    bool is_a_cut = size_of(a) >= size_of(b);
    // Of what is undecided both are arcs, also where several segments are smaller than one arc.
    if (is_too_short(is_a_cut ? a : b) && !(is_a_cut ? b : a).is_arc()) is_a_cut = !is_a_cut;
    CurveNode& longer = is_a_cut ? a : b;
    CurveTree& tree = is_a_cut ? first_ : second_;
    if (is_too_short(longer)) return leave_undecided({part_of(a), part_of(b)});
    if (!are_neighbours && (is_idle_beside(a, b) || is_idle_beside(b, a))) return true;
    tree.split(longer);
    const auto with_half = [&](CurveNode& half) {
      return &longer == &a ? visit_pair(half, b) : visit_pair(a, half);
    };
    return with_half(*longer.halves[0]) && with_half(*longer.halves[1]);
  }

  struct Solution {
    bool is_decided = false;
    std::optional<NewtonStep> crossing = {};
    std::optional<UndecidedCrossing> place = {};  ///< where it is, if it is not decided
  };
  Solution solve(const CurveNode& a, const CurveNode& b) const;
  NewtonStep step(const CurveNode& a, const RealBall& s, const CurveNode& b, const RealBall& t,
                  long bits) const;
  bool add_crossing(const CurveNode& a, const CurveNode& b, NewtonStep at);
  bool are_told_closely(const CurveNode& a, const CurveNode& b);
  int sign_at(const CurveNode& a, const RealBall& s, const CurveNode& b, const RealBall& t,
              long bits) const;

  bool is_idle(CurveNode& node) const {
    if (!query_.is_idle) return false;
    if (!node.is_idle) node.is_idle = query_.is_idle(node);
    return *node.is_idle;
  }
  /// Looked at again after three halvings.
  bool is_idle_beside(CurveNode& node, const CurveNode& other) const {
    if (!query_.is_idle_beside || !node.is_arc() || !other.is_arc()) return false;
    const int depth = -std::ilogb(node.upper - node.lower);
    if (depth < 5 || depth % 3 != 2) return false;
    const bool is_idle = query_.is_idle_beside(node, other);
    if (is_idle) node.is_idle = true;
    return is_idle;
  }
  bool is_known(const CurveNode& a, const CurveNode& b) const;
  bool leave_undecided(const UndecidedCrossing& place);
  bool add_undecided(const UndecidedCrossing& place);
  bool is_left() { return ++pairs_ <= most_pairs_; }
  /// In the plane that of the box: neighbouring segments may have quite different speeds.
  double size_of(const CurveNode& node) const {
    if (is_plane())
      return std::max(node.box[0].upper - node.box[0].lower, node.box[1].upper - node.box[1].lower);
    return static_cast<double>(node.last_segment - node.first_segment) + node.upper - node.lower;
  }
  bool is_too_short(const CurveNode& node) const {
    return node.is_arc() && node.upper - node.lower < (is_plane() ? least_plane_arc : least_arc);
  }

  CurveTree& first_;
  CurveTree& second_;
  CloseSearch* close_ = nullptr;  ///< of a curve in a plane
  long close_failures_ = 0;
  long most_pairs_ = most_pairs;
  CrossingQuery query_ = {};
  long pairs_ = 0;
  std::vector<Crossing> found_;
  std::vector<UndecidedCrossing> undecided_;
};

bool is_on(const CurveNode& arc, std::size_t segment, const RealAlgebraic& t) {
  return arc.first_segment == segment && compare(t, exact_sum(arc.lower, 0).midpoint()) >= 0 &&
         compare(t, exact_sum(arc.upper, 0).midpoint()) <= 0;
}

/// Is there a point that the arcs are known to have in common? If they are transversal, they have
/// no other one.
bool CrossingSearch::is_known(const CurveNode& a, const CurveNode& b) const {
  return std::ranges::any_of(query_.known, [&](const KnownMeeting& x) {
    return is_on(a, x.first_segment, x.first_t) && is_on(b, x.second_segment, x.second_t);
  });
}

/// The least part around both, where they are of one segment and not far from each other.
std::optional<CurvePart> merged(const CurvePart& a, const CurvePart& b) {
  constexpr double near = 0x1p-20;
  if (a.segment != b.segment || a.lower > b.upper + near || b.lower > a.upper + near)
    return std::nullopt;
  return CurvePart{a.segment, std::min(a.lower, b.lower), std::max(a.upper, b.upper)};
}

/// Are all their crossings found by balls?
bool CrossingSearch::are_told_closely(const CurveNode& a, const CurveNode& b) {
  if (close_failures_ > most_close_failures || is_known(a, b)) return false;
  const auto found = close_->crossings(part_of(a), part_of(b));
  if (!found) {
    ++close_failures_;
    return false;
  }
  found_.insert(found_.end(), found->begin(), found->end());
  return true;
}

/// Goes on without these, of a curve in a plane.
bool CrossingSearch::leave_undecided(const UndecidedCrossing& place) {
  if (!is_plane()) return false;
  for (auto& [first, second] : undecided_) {
    const auto one = merged(first, place.first);
    const auto other = merged(second, place.second);
    if (!one || !other) continue;
    first = *one;
    second = *other;
    return true;
  }
  return add_undecided(place);
}

bool CrossingSearch::add_undecided(const UndecidedCrossing& place) {
  undecided_.push_back(place);
  return undecided_.size() < most_undecided + 8 * first_.root().last_segment;
}

SelfIntersections CrossingSearch::in_plane() {
  SelfIntersections result;
  result.is_cut_off = !visit_self(first_.root());
  const auto place = [](std::size_t segment, double t) { return std::pair(segment, t); };
  std::ranges::sort(found_, {}, [&](const Crossing& x) {
    return place(x.first_segment, approximate(x.first_t));
  });
  std::ranges::sort(undecided_, {}, [&](const UndecidedCrossing& x) {
    return place(x.first.segment, x.first.lower);
  });
  result.found = std::move(found_);
  result.undecided = std::move(undecided_);
  return result;
}

NewtonStep CrossingSearch::step(const CurveNode& a, const RealBall& s, const CurveNode& b,
                                const RealBall& t, long bits) const {
  const auto of = [](const CurveTree& tree) {
    return [&tree](std::size_t segment, const RealBall& at, long length, long precision) {
      return tree.series(segment, at, length, precision);
    };
  };
  return newton(of(first_), a.first_segment, s, of(second_), b.first_segment, t, bits);
}

// All that is in both arcs is in N, and so in what they have in common, of which there is a next N.
// Near an end of an arc, where a crossing may be just inside or just outside, that decides in few
// steps what halving would not.
CrossingSearch::Solution CrossingSearch::solve(const CurveNode& a, const CurveNode& b) const {
  RealBall s = arc_parameter(a);
  RealBall t = arc_parameter(b);
  for (long bits = crossing_bits;;) {
    const NewtonStep found = step(a, s, b, t, bits);
    if (is_outside(found.first, a) || is_outside(found.second, b)) return {true};
    if (is_inside(found.first, s, a) && is_inside(found.second, t, b)) return {true, found};
    const long before = exponent_of_width(s, t);
    s = common_of(found.first, s, a, bits);
    t = common_of(found.second, t, b, bits);
    const long exponent = exponent_of_width(s, t);
    if (exponent >= before) return {};
    bits = crossing_bits - 4 * std::min(exponent, 0L);
    if (bits <= most_crossing_bits) continue;
    if (!is_plane()) return {};
    return {false, {}, UndecidedCrossing{part_of(a, s), part_of(b, t)}};
  }
}

int CrossingSearch::sign_at(const CurveNode& a, const RealBall& s, const CurveNode& b,
                            const RealBall& t, long bits) const {
  const Vector<BallPolynomial> p = first_.space_series(a.first_segment, s, 2, bits);
  const Vector<BallPolynomial> q = second_.space_series(b.first_segment, t, 2, bits);
  if (is_plane())
    return sign(subtract(multiply(p[0].coefficient(1), q[1].coefficient(1), bits),
                         multiply(p[1].coefficient(1), q[0].coefficient(1), bits), bits));
  RealBall determinant;
  for (std::size_t k = 0; k < 3; ++k) {
    const std::size_t i = (k + 1) % 3;
    const std::size_t j = (k + 2) % 3;
    const RealBall minor = subtract(multiply(p[i].coefficient(1), q[j].coefficient(1), bits),
                                    multiply(p[j].coefficient(1), q[i].coefficient(1), bits), bits);
    const RealBall gap = subtract(p[k].coefficient(0), q[k].coefficient(0), bits);
    determinant = add_product(determinant, minor, gap, bits);
  }
  return sign(determinant);
}

/// Narrows it until its sign is certain, and its place is known to some digits.
bool CrossingSearch::add_crossing(const CurveNode& a, const CurveNode& b, NewtonStep at) {
  constexpr int most_steps = 8;
  int sign = 0;
  for (int steps = 0; steps < most_steps; ++steps) {
    // More of them for a parameter that is nearly 0.
    const long below = std::min(exponent_below(at.first), exponent_below(at.second));
    const long bits =
        (crossing_bits << (steps / 4)) +
        std::clamp(-2 * below, 0L, below == -unbounded_exponent ? 0 : most_crossing_bits);
    sign = sign_at(a, at.first, b, at.second, bits);
    if (sign != 0 && at.first.accuracy_bits() >= 40 && at.second.accuracy_bits() >= 40) break;
    const NewtonStep next = step(a, at.first, b, at.second, bits);
    if (next.first.is_finite() && next.second.is_finite()) at = next;
  }
  if (sign == 0) return leave_undecided({part_of(a), part_of(b)});
  found_.push_back({a.first_segment, at.first, b.first_segment, at.second, sign});
  return true;
}

}  // namespace

std::optional<std::vector<Crossing>> self_crossings(const CurveSeries& curve,
                                                    const Vector<Rational>& v) {
  CurveTree tree(curve, v);
  return CrossingSearch(tree, tree).with_itself();
}

std::optional<std::vector<Crossing>> mutual_crossings(const CurveSeries& first,
                                                      const CurveSeries& second,
                                                      const Vector<Rational>& v) {
  CurveTree one(first, v);
  CurveTree other(second, v);
  return CrossingSearch(one, other).with_other();
}

SelfIntersections self_intersections(const CurveSeries& curve, const CrossingQuery& query) {
  CurveTree tree(curve, {0, 0, 1});
  CloseSearch close(curve);
  return CrossingSearch(tree, query, close).in_plane();
}

long sum_of_signs(const std::vector<Crossing>& crossings) {
  long sum = 0;
  for (const Crossing& crossing : crossings) sum += crossing.sign;
  return sum;
}

}  // namespace phrame
