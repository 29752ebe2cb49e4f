#include "phrame/ph/curve/curve_arc.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "phrame/algebra/ball_order.hpp"
#include "phrame/ph/curve/vector.hpp"

// Why a part of a plane curve P′ = p·H/W² does not meet itself, where H is in an open half-plane,
// d·H > 0. If p keeps its sign, d·P increases or decreases, so that no point is met twice; that
// holds of a way of many parts, too, whatever their sizes, if d·H > 0 with one d on all of it. If p
// changes it at one place c, and H turns one way, the angle φ of H against H(c) has the sign of t −
// c, or the opposite one, and so p·sin φ one sign: P moves to one side of the line through P(c)
// along H(c) on both branches of the cusp, so that P(s) = P(t) would need s, t on one side of c,
// where p keeps its sign. The same holds where two segments with one tangent turn back at their
// joint, one of which may be straight. There it may also be that they turn to different sides, or
// have a different curvature only. Over X along the tangent both are then graphs on one side, with
// d(sin φ)/dX = κ: where all κ of the one are less than all of the other, so are the slopes, and
// the graphs meet at the joint alone.
//
// Of the offset at d > 0 of a curve with the curvature k it is known that they are: where 1 + dk >
// 0 it has κ = k/(1 + dk) < 1/d, and where 1 + dk < 0 κ > 1/d. So the branches at a cusp part to
// both sides of a circle of the radius d, whatever inflections they have; for d < 0 likewise. Under
// a gauge there is 1/(dρ(φ)) for 1/d, where ρ > 0 is the radius of curvature of U where its tangent
// has the angle φ: then dφ/dX is less than g(φ) on one branch and more on the other one, so that
// φ is less than the solution of dφ/dX = g(φ) on one and more on the other one, for these X, too.

namespace phrame::inline v0 {
namespace {

constexpr long arc_bits = 64;
/// The error of a few sums and products of doubles, relative to the sum of their sizes.
constexpr double slack = 0x1p-48;

double size_of(const DoubleInterval& x) { return std::max(std::abs(x.lower), std::abs(x.upper)); }

/// A little more than x·y.
DoubleInterval product(const DoubleInterval& x, const DoubleInterval& y) {
  const auto [least, most] =
      std::minmax({x.lower * y.lower, x.lower * y.upper, x.upper * y.lower, x.upper * y.upper});
  const double error = slack * size_of(x) * size_of(y);
  return {least - error, most + error};
}

bool is_bounded(const PlaneBox& box) {
  return std::all_of(box.begin(), box.end(), [](const DoubleInterval& x) {
    return std::isfinite(x.lower) && std::isfinite(x.upper) && size_of(x) < 1e150;
  });
}

DoubleInterval difference(const DoubleInterval& x, const DoubleInterval& y) {
  const DoubleInterval rounded{x.lower - y.upper, x.upper - y.lower};
  const double error = slack * size_of(rounded);
  return {rounded.lower - error, rounded.upper + error};
}

/// A little more than a·b.
DoubleInterval dot_product(const std::array<double, 2>& a, const PlaneBox& b) {
  const DoubleInterval x = product({a[0], a[0]}, b[0]);
  const DoubleInterval y = product({a[1], a[1]}, b[1]);
  const double error = slack * (size_of(x) + size_of(y));
  return {x.lower + y.lower - error, x.upper + y.upper + error};
}

/// How many of these, ascending, are in (a, b); in (a, b] or [a, b) those at the end, too.
long count_between(const std::vector<RealAlgebraic>& places, double a, double b, bool with_a,
                   bool with_b) {
  const Rational lower = exact_sum(a, 0).midpoint();
  const Rational upper = exact_sum(b, 0).midpoint();
  return std::count_if(places.begin(), places.end(), [&](const RealAlgebraic& x) {
    const auto below = compare(x, lower);
    const auto above = compare(x, upper);
    return (with_a ? below >= 0 : below > 0) && (with_b ? above <= 0 : above < 0);
  });
}

/// The sign after so many changes of it.
int changed(int sign, long changes) { return changes % 2 == 0 ? sign : -sign; }

/// A place of a curve.
using CurvePlace = std::pair<std::size_t, double>;
CurvePlace start_of(const CurveNode& node) { return {node.first_segment, node.lower}; }
CurvePlace end_of(const CurveNode& node) { return {node.last_segment, node.upper}; }

/// The parts of a way, whose directions may be in one half-plane.
class OneWay {
 public:
  explicit OneWay(CurveTree& tree) : tree_(tree) {}

  /// With all that follows the last one, from `from` to `to`; false where it is none.
  bool add(CurveNode& node, const CurvePlace& from, const CurvePlace& to) {
    if (end_of(node) <= from || start_of(node) >= to) return true;
    if (start_of(node) >= from && end_of(node) <= to) {
      if (node.reversals > 1 || (node.reversals == 1 && !node.parts_at_reversals)) return false;
      if (is_narrow(node.direction) || node.upper - node.lower < least_part) return add(node);
    }
    tree_.split(node);
    return add(*node.halves[0], from, to) && add(*node.halves[1], from, to);
  }

  /// Is it a way, on which d·H > 0?
  bool is_seen() const {
    if (reversals_ > 0 && !parts_at_reversals_) return false;
    const std::array<double, 2> d{right_[0] + left_[0], right_[1] + left_[1]};
    return std::ranges::all_of(parts_, [&](const CurveNode* node) {
      return dot_product(d, node->direction).lower > std::numeric_limits<double>::min();
    });
  }

 private:
  bool add(const CurveNode& node) {
    reversals_ += node.reversals;
    parts_at_reversals_ = parts_at_reversals_ && node.parts_at_reversals;
    if (!parts_.empty()) {
      const CurveNode& last = *parts_.back();
      if (last.last_sign != node.first_sign) ++reversals_;
      if (last.upper == 1 && !tree_.is_smooth_behind(last.last_segment))
        parts_at_reversals_ = false;
    }
    if (reversals_ > (parts_at_reversals_ ? 1 : 0)) return false;
    parts_.push_back(&node);
    for (const double x : {node.direction[0].lower, node.direction[0].upper})
      for (const double y : {node.direction[1].lower, node.direction[1].upper})
        if (!widen({x, y}, std::hypot(x, y))) return false;
    return true;
  }

  /// Rounded: is_seen() has the last word.
  bool widen(std::array<double, 2> h, double length) {
    for (double& x : h) x /= length;
    const auto cross = [](const auto& a, const auto& b) { return a[0] * b[1] - a[1] * b[0]; };
    if (right_ == left_ && right_[0] == 0 && right_[1] == 0) right_ = left_ = h;
    const bool is_right = cross(right_, h) < 0;
    const bool is_left = cross(left_, h) > 0;
    if (is_right) right_ = h;
    if (is_left) left_ = h;
    return !(is_right && is_left);
  }

  static constexpr double least_part = 0x1p-8;

  /// Is it seen within less than a quarter of a turn?
  static bool is_narrow(const PlaneBox& direction) {
    double width = 0;
    double middle = 0;
    for (const DoubleInterval& x : direction) {
      width = std::max(width, x.upper - x.lower);
      middle = std::max(middle, std::abs(x.lower / 2 + x.upper / 2));
    }
    return 2 * width < middle;
  }

  CurveTree& tree_;
  std::vector<const CurveNode*> parts_;
  long reversals_ = 0;
  bool parts_at_reversals_ = true;  ///< would each of them?
  std::array<double, 2>
      right_{};                   ///< of the directions up to now the one that is most to the right
  std::array<double, 2> left_{};  ///< and to the left
};

/// More than one reversal: what has a gap is not seen not to meet itself.
constexpr long not_seen = 2;

}  // namespace

DoubleInterval doubles_around(const RealBall& x) {
  constexpr double infinity = std::numeric_limits<double>::infinity();
  if (!x.is_finite()) return {-infinity, infinity};
  return {-upper_double(subtract({}, x, arc_bits)), upper_double(x)};
}

bool are_apart(const PlaneBox& a, const PlaneBox& b) {
  for (std::size_t k = 0; k < 2; ++k)
    if (a[k].upper < b[k].lower || b[k].upper < a[k].lower) return true;
  return false;
}

PlaneBox common_of(const PlaneBox& a, const PlaneBox& b) {
  PlaneBox common;
  for (std::size_t k = 0; k < 2; ++k)
    common[k] = {std::max(a[k].lower, b[k].lower), std::min(a[k].upper, b[k].upper)};
  return common;
}

PlaneBox hull_of(const PlaneBox& a, const PlaneBox& b) {
  PlaneBox hull;
  for (std::size_t k = 0; k < 2; ++k)
    hull[k] = {std::min(a[k].lower, b[k].lower), std::max(a[k].upper, b[k].upper)};
  return hull;
}

bool is_one_way(const PlaneBox& velocity) {
  if (!is_bounded(velocity)) return false;
  double least = 0;
  double error = 0;
  for (const DoubleInterval& x : velocity) {
    const double d = x.lower / 2 + x.upper / 2;
    least += std::min(d * x.lower, d * x.upper);
    error += slack * std::abs(d) * size_of(x);
  }
  return least > error && error > std::numeric_limits<double>::min();
}

bool are_transversal(const PlaneBox& a, const PlaneBox& b) {
  if (!is_bounded(a) || !is_bounded(b)) return false;
  const DoubleInterval left = product(a[0], b[1]);
  const DoubleInterval right = product(a[1], b[0]);
  return left.lower > right.upper || left.upper < right.lower;
}

namespace {

/// Two arcs seen along a normal of the first one.
struct AcrossView {
  DoubleInterval gap;  ///< of their middles
  double reach;        ///< how far both go from these, taken together
  double length;       ///< how far the longer one does along the first one
};

// With P = P(m) + P′(m)·u + ½P″·u² at m + u: of short arcs what is across is as small as u², while
// a box of P′ is as wide across as along, where the speed changes, as it does next to a cusp.
std::optional<AcrossView> across(const CurveNode& a, const CurveNode& b) {
  for (const CurveNode* node : {&a, &b})
    if (!is_bounded(node->slope) || !is_bounded(node->bend)) return std::nullopt;
  const std::array<double, 2> normal{-(a.slope[1].lower / 2 + a.slope[1].upper / 2),
                                     a.slope[0].lower / 2 + a.slope[0].upper / 2};
  const auto reach = [&](const CurveNode& node) {
    const double u = (node.upper - node.lower) * 0.5000001;  // a little more than half of it
    return (size_of(dot_product(normal, node.slope)) +
            size_of(dot_product(normal, node.bend)) * u) *
           u;
  };
  const auto length = [&](const CurveNode& node) {
    const double along = normal[1] * node.slope[0].lower - normal[0] * node.slope[1].lower;
    return std::abs(along) * (node.upper - node.lower);
  };
  return AcrossView{dot_product(normal, {difference(a.middle[0], b.middle[0]),
                                         difference(a.middle[1], b.middle[1])}),
                    (reach(a) + reach(b)) * (1 + slack), std::max(length(a), length(b))};
}

}  // namespace

bool are_apart_across(const CurveNode& a, const CurveNode& b) {
  const auto view = across(a, b);
  if (!view) return false;
  const double distance = std::max(view->gap.lower, -view->gap.upper);
  return distance > view->reach && distance > 1e-300;
}

bool are_nearly_parallel(const CurveNode& a, const CurveNode& b) {
  constexpr double thin = 0x1p-5;
  const auto view = across(a, b);
  return view && (view->reach < thin * view->length ||
                  view->gap.upper - view->gap.lower > thin * view->reach);
}

RealBall arc_parameter(const CurveNode& arc) {
  return hull(exact_sum(arc.lower, 0), exact_sum(arc.upper, 0), 2 * arc_bits);
}

RealBall midpoint_of(const RealBall& x) { return RealBall(x.midpoint(), 4096); }

CurveTree::CurveTree(CurveSeries curve, const Vector<Rational>& v) : curve_(std::move(curve)) {
  // Along the axis in which v is least, so that a is not short; a × b = |a|²·v.
  std::size_t least = 0;
  for (std::size_t k = 1; k < 3; ++k)
    if (abs(v[k]) < abs(v[least])) least = k;
  Vector<Rational> axis{};
  axis[least] = 1;
  axes_ = {cross(axis, v), cross(v, cross(axis, v))};
  last_in_order_.assign(curve_.segments, curve_.segments - 1);
  for (std::size_t k = curve_.segments - 1; k-- > 0;)
    last_in_order_[k] = behind(k) == k + 1 ? last_in_order_[k + 1] : k;
  root_ = make_group(0, curve_.segments - 1);
}

PlaneSeries CurveTree::projected(const Vector<BallPolynomial>& r, long bits) const {
  PlaneSeries plane;
  for (std::size_t k = 0; k < 2; ++k)
    for (std::size_t j = 0; j < 3; ++j)
      if (axes_[k][j] != 0)
        plane[k] = add(plane[k], multiply(RealBall(axes_[k][j], bits), r[j], bits), bits);
  return plane;
}

PlaneSeries CurveTree::series(std::size_t segment, const RealBall& t, long length,
                              long bits) const {
  return projected(curve_.position(segment, t, length, bits), bits);
}

std::size_t CurveTree::behind(std::size_t segment) const {
  return curve_.behind.empty() ? (segment + 1) % curve_.segments : curve_.behind[segment];
}

bool CurveTree::is_smooth_behind(std::size_t segment) const {
  if (curve_.turning.empty()) return true;
  const Vector<Rational>& before = curve_.turning[segment].last_direction;
  const Vector<Rational>& after = curve_.turning[behind(segment)].first_direction;
  return before[0] * after[1] == before[1] * after[0];
}

void CurveTree::add_turning(CurveNode& arc, const RealBall& all, const RealBall& middle) const {
  arc.direction = arc.velocity;
  if (curve_.turning.empty()) return;
  const RealBall step = subtract(all, middle, arc_bits);
  const PlaneSeries there =
      projected(curve_.direction(arc.first_segment, middle, 1, arc_bits), arc_bits);
  const PlaneSeries over =
      projected(curve_.direction(arc.first_segment, all, 2, arc_bits), arc_bits);
  for (std::size_t k = 0; k < 2; ++k)
    arc.direction[k] = doubles_around(
        add_product(there[k].coefficient(0), over[k].coefficient(1), step, arc_bits));
  const SegmentTurning& turning = curve_.turning[arc.first_segment];
  const auto& turns_back = turning.reversals;
  arc.reversals = count_between(turns_back, arc.lower, arc.upper, false, false);
  arc.first_sign =
      changed(turning.first_sign, count_between(turns_back, 0, arc.lower, false, true));
  arc.last_sign = changed(arc.first_sign, arc.reversals);
  arc.is_straight = turning.first_turn == 0;
  arc.has_break = count_between(turning.breaks, arc.lower, arc.upper, true, true) > 0;
  arc.parts_at_reversals = turning.parts_at_reversals && !arc.has_break;
  if (count_between(turning.inflections, arc.lower, arc.upper, false, false) == 0)
    arc.turn =
        changed(turning.first_turn, count_between(turning.inflections, 0, arc.lower, false, true));
}

std::unique_ptr<CurveNode> CurveTree::make_segment(std::size_t segment) const {
  constexpr double infinity = std::numeric_limits<double>::infinity();
  PlaneBox around{DoubleInterval{-infinity, infinity}, DoubleInterval{-infinity, infinity}};
  if (!curve_.boxes.empty()) {
    Vector<BallPolynomial> box;
    for (std::size_t k = 0; k < 3; ++k)
      box[k] = BallPolynomial(std::vector{curve_.boxes[segment][k]});
    const PlaneSeries plane = projected(box, arc_bits);
    for (std::size_t k = 0; k < 2; ++k) around[k] = doubles_around(plane[k].coefficient(0));
  }
  return make_arc(segment, 0, 1, around);
}

// Taylor's polynomials around the middle, whose last coefficient is that of the whole arc.
std::unique_ptr<CurveNode> CurveTree::make_arc(std::size_t segment, double lower, double upper,
                                               const PlaneBox& around) const {
  auto node = std::make_unique<CurveNode>();
  node->first_segment = node->last_segment = segment;
  node->lower = lower;
  node->upper = upper;
  const RealBall all = arc_parameter(*node);
  const RealBall middle = midpoint_of(all);
  const RealBall step = subtract(all, middle, arc_bits);
  const PlaneSeries there = series(segment, middle, 2, arc_bits);
  const PlaneSeries over = series(segment, all, 3, arc_bits);
  for (std::size_t k = 0; k < 2; ++k) {
    const RealBall bend = multiply(over[k].coefficient(2), step, arc_bits);
    const RealBall slope = add(there[k].coefficient(1), bend, arc_bits);
    node->box[k] = doubles_around(add_product(there[k].coefficient(0), slope, step, arc_bits));
    node->velocity[k] = doubles_around(add(slope, bend, arc_bits));
    node->middle[k] = doubles_around(there[k].coefficient(0));
    node->slope[k] = doubles_around(there[k].coefficient(1));
    node->bend[k] = doubles_around(over[k].coefficient(2));
  }
  node->box = common_of(node->box, around);
  add_turning(*node, all, middle);
  return node;
}

std::unique_ptr<CurveNode> CurveTree::make_group(std::size_t first, std::size_t last) const {
  if (first == last) return make_segment(first);
  auto node = std::make_unique<CurveNode>();
  node->first_segment = first;
  node->last_segment = last;
  const std::size_t middle = first + (last - first) / 2;
  node->halves = {make_group(first, middle), make_group(middle + 1, last)};
  const CurveNode& one = *node->halves[0];
  const CurveNode& other = *node->halves[1];
  node->box = hull_of(one.box, other.box);
  node->velocity = hull_of(one.velocity, other.velocity);
  node->direction = hull_of(one.direction, other.direction);
  node->first_sign = one.first_sign;
  node->last_sign = other.last_sign;
  node->reversals = one.reversals + other.reversals;
  if (one.last_sign != other.first_sign) ++node->reversals;
  if (behind(middle) != middle + 1) node->reversals += not_seen;
  node->has_break = one.has_break || other.has_break;
  node->parts_at_reversals = one.parts_at_reversals && other.parts_at_reversals &&
                             (behind(middle) == no_segment || is_smooth_behind(middle));
  return node;
}

// Not in the middle, where curves with symmetries have crossings.
void CurveTree::split(CurveNode& node) {
  if (node.halves[0]) return;
  const double cut = node.lower + (node.upper - node.lower) * 0.4837;
  node.halves = {make_arc(node.first_segment, node.lower, cut, node.box),
                 make_arc(node.first_segment, cut, node.upper, node.box)};
}

/// Does b begin where a ends? 1 of a segment is 0 of the one behind it.
bool CurveTree::goes_on_into(const CurveNode& a, const CurveNode& b) const {
  if (a.upper < 1) return a.last_segment == b.first_segment && a.upper == b.lower;
  return b.lower == 0 && b.first_segment == behind(a.last_segment);
}

bool CurveTree::share_end(const CurveNode& a, const CurveNode& b) const {
  return goes_on_into(a, b) || goes_on_into(b, a);
}

bool CurveTree::is_simple(const CurveNode& node, bool is_one_branch_asked) const {
  return is_one_way(node.direction) &&
         (node.reversals == 0 ||
          (node.reversals == 1 && (node.turn != 0 || node.parts_at_reversals ||
                                   (is_one_branch_asked && !node.has_break))));
}

/// Around the curvature along H.
DoubleInterval CurveTree::curvature_of(const CurveNode& arc) const {
  const PlaneSeries r = series(arc.first_segment, arc_parameter(arc), 3, arc_bits);
  const auto product_of = [&](std::size_t k, long i, std::size_t m, long j) {
    return multiply(r[k].coefficient(i), r[m].coefficient(j), arc_bits);
  };
  const RealBall turn = subtract(product_of(0, 1, 1, 2), product_of(1, 1, 0, 2), arc_bits);
  const RealBall square = add(product_of(0, 1, 0, 1), product_of(1, 1, 1, 1), arc_bits);
  const RealBall cube = multiply(square, sqrt(square, arc_bits), arc_bits);
  return doubles_around(divide(
      times_power_of_two(multiply(turn, RealBall(arc.first_sign, 64), 64), 1), cube, arc_bits));
}

/// Do they part where the second one turns back behind the first one?
bool CurveTree::are_parted(const CurveNode& one, const CurveNode& other) const {
  if (!one.is_arc() || !other.is_arc() || one.reversals != 0 || other.reversals != 0) return false;
  if (one.upper < 1 || !is_smooth_behind(one.last_segment)) return false;
  // All directions of both are within a right angle.
  const PlaneBox all = hull_of(one.direction, other.direction);
  const DoubleInterval x = product(all[0], all[0]);
  const DoubleInterval y = product(all[1], all[1]);
  if (!is_bounded(all) || x.lower + y.lower <= slack * (size_of(x) + size_of(y))) return false;
  const DoubleInterval a = curvature_of(one);
  const DoubleInterval b = curvature_of(other);
  return a.upper < b.lower || b.upper < a.lower;
}

bool CurveTree::are_simple(const CurveNode& a, const CurveNode& b, bool is_one_branch_asked) const {
  const bool is_in_order = goes_on_into(a, b);
  const CurveNode& one = is_in_order ? a : b;
  const CurveNode& other = is_in_order ? b : a;
  if (one.reversals == 0 && other.reversals == 0 && are_transversal(a.direction, b.direction))
    return true;
  if (!is_one_way(hull_of(a.direction, b.direction))) return false;
  const long reversals =
      one.reversals + other.reversals + (one.last_sign != other.first_sign ? 1 : 0);
  if (reversals == 1 && is_one_branch_asked && !one.has_break && !other.has_break) return true;
  const bool is_smooth = one.upper < 1 || is_smooth_behind(one.last_segment);
  const bool turns_one_way = (one.turn != 0 || one.is_straight) &&
                             (other.turn != 0 || other.is_straight) && one.turn + other.turn != 0;
  const bool parts = one.parts_at_reversals && other.parts_at_reversals;
  return reversals == 0 ||
         (reversals == 1 && ((is_smooth && (turns_one_way || parts)) || are_parted(one, other)));
}

bool CurveTree::leads_one_way(const CurveNode& a, const CurveNode& b) {
  OneWay way(*this);
  const std::size_t last = last_in_order_[a.first_segment];
  if (start_of(a) < start_of(b))
    return last >= b.last_segment && way.add(*root_, start_of(a), end_of(b)) && way.is_seen();
  const std::size_t first = behind(last);
  return last >= a.last_segment && first <= b.first_segment &&
         last_in_order_[first] >= b.last_segment && way.add(*root_, start_of(a), {last, 1}) &&
         way.add(*root_, {first, 0}, end_of(b)) && way.is_seen();
}

bool CurveTree::are_on_one_way(const CurveNode& a, const CurveNode& b) {
  return leads_one_way(a, b) || leads_one_way(b, a);
}

}  // namespace phrame
