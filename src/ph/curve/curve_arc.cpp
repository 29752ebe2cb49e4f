#include "phrame/ph/curve/curve_arc.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "phrame/algebra/ball_order.hpp"
#include "phrame/ph/curve/vector.hpp"

namespace phrame {
namespace {

constexpr long arc_bits = 64;
/// The error of a few sums and products of doubles, relative to the sum of their sizes.
constexpr double slack = 0x1p-48;

double size_of(const DoubleInterval& x) { return std::max(std::abs(x.lower), std::abs(x.upper)); }

DoubleInterval interval_of(const RealBall& x) {
  constexpr double infinity = std::numeric_limits<double>::infinity();
  if (!x.is_finite()) return {-infinity, infinity};
  return {-upper_double(subtract({}, x, arc_bits)), upper_double(x)};
}

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

/// Where a part begins or ends: 1 of a segment is 0 of the next one, and the last one is the first.
struct NodeEnd {
  std::size_t segment;
  double t;
  friend bool operator==(const NodeEnd&, const NodeEnd&) = default;
};

NodeEnd normal_end(std::size_t segment, double t, std::size_t segments) {
  return t < 1 ? NodeEnd{segment, t} : NodeEnd{(segment + 1) % segments, 0};
}

}  // namespace

bool are_apart(const PlaneBox& a, const PlaneBox& b) {
  for (std::size_t k = 0; k < 2; ++k)
    if (a[k].upper < b[k].lower || b[k].upper < a[k].lower) return true;
  return false;
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
  root_ = make_group(0, curve_.segments - 1);
}

PlaneSeries CurveTree::series(std::size_t segment, const RealBall& t, long length,
                              long bits) const {
  const Vector<BallPolynomial> r = curve_.position(segment, t, length, bits);
  PlaneSeries plane;
  for (std::size_t k = 0; k < 2; ++k)
    for (std::size_t j = 0; j < 3; ++j)
      plane[k] = add(plane[k], multiply(RealBall(axes_[k][j], bits), r[j], bits), bits);
  return plane;
}

// Taylor's polynomials around the middle, whose last coefficient is that of the whole arc.
std::unique_ptr<CurveNode> CurveTree::make_arc(std::size_t segment, double lower,
                                               double upper) const {
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
    node->box[k] = interval_of(add_product(there[k].coefficient(0), slope, step, arc_bits));
    node->velocity[k] = interval_of(add(slope, bend, arc_bits));
  }
  return node;
}

std::unique_ptr<CurveNode> CurveTree::make_group(std::size_t first, std::size_t last) const {
  if (first == last) return make_arc(first, 0, 1);
  auto node = std::make_unique<CurveNode>();
  node->first_segment = first;
  node->last_segment = last;
  const std::size_t middle = first + (last - first) / 2;
  node->halves = {make_group(first, middle), make_group(middle + 1, last)};
  node->box = hull_of(node->halves[0]->box, node->halves[1]->box);
  node->velocity = hull_of(node->halves[0]->velocity, node->halves[1]->velocity);
  return node;
}

// Not in the middle, where curves with symmetries have crossings.
void CurveTree::split(CurveNode& node) {
  if (node.halves[0]) return;
  const double cut = node.lower + (node.upper - node.lower) * 0.4837;
  node.halves = {make_arc(node.first_segment, node.lower, cut),
                 make_arc(node.first_segment, cut, node.upper)};
}

bool CurveTree::share_end(const CurveNode& a, const CurveNode& b) const {
  const auto start = [&](const CurveNode& node) {
    return normal_end(node.first_segment, node.lower, curve_.segments);
  };
  const auto end = [&](const CurveNode& node) {
    return normal_end(node.last_segment, node.upper, curve_.segments);
  };
  return end(a) == start(b) || end(b) == start(a);
}

}  // namespace phrame
