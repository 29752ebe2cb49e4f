// Let Q be a point of both sides: Q = r(s) + d·n(s) = r(t) − d·n(t). Then r(t) − r(s) = d·(n(s) +
// n(t)) is across e₁(s) + e₁(t), or both are 0, as the normals are the e₁ turned. But r(t) − r(s)
// is a sum of r′ between s and t: where all these r′ are ahead of e₁(s) + e₁(t), that is, their
// products with it are > 0, or all of them < 0, there is no such Q. The same holds of an arc about
// a point of the path, r there, with an e₁ of its own for each n.
#include "phrame/ph/offset/two_sides.hpp"

#include <algorithm>
#include <cmath>

#include "phrame/algebra/ball_order.hpp"
#include "phrame/ph/curve/special_points.hpp"
#include "phrame/ph/offset/plane_tangent.hpp"

namespace phrame::inline v0 {
namespace {

constexpr long side_bits = 64;

RealBall ball_of(const DoubleInterval& x) {
  return hull(exact_sum(x.lower, 0), exact_sum(x.upper, 0), side_bits);
}

/// Of the parameters of the path.
struct FootRange {
  std::size_t segment;
  double from;
  double to;
};

/// 1 − t is rounded outwards.
FootRange range_of(const SideFoot& foot, const CurveNode& arc) {
  if (foot.point) {
    const double t = *foot.point == 0 ? 0 : 1;
    return {foot.segment, t, t};
  }
  if (!foot.is_reversed) return {foot.segment, arc.lower, arc.upper};
  return {foot.segment, std::max(0.0, std::nextafter(1 - arc.upper, 0.0)),
          std::min(1.0, std::nextafter(1 - arc.lower, 1.0))};
}

}  // namespace

/// e₁ along two arcs, of any lengths.
class TwoSides::Pair {
 public:
  Pair(const TwoSides& sides, const CurveNode& a, const SideFoot& at_a, const CurveNode& b,
       const SideFoot& at_b)
      : sides_(sides), a_(tangent(a, at_a)), b_(tangent(b, at_b)) {}

  const PlaneBall& first() const { return a_; }
  const PlaneBall& second() const { return b_; }

  /// Is a tangent of the path ahead of all sums of them as unit vectors?
  bool is_ahead(const PlaneBall& along) const {
    const RealBall p = dot(along, a_, side_bits);
    const RealBall q = dot(along, b_, side_bits);
    if (sign(p) > 0 && sign(q) > 0) return true;
    const auto over = [](const RealBall& x, const PlaneBall& e) {
      return divide(x, sqrt(dot(e, e, side_bits), side_bits), side_bits);
    };
    return sign(add(over(p, a_), over(q, b_), side_bits)) > 0;
  }

  /// Are all from one place of the path up to another one, with this sign of r′·e₁?
  bool is_ahead(std::size_t first, double from, std::size_t last, double to, int sign) const {
    for (std::size_t k = first; k <= last; ++k) {
      const double lower = k == first ? from : 0;
      const double upper = k == last ? to : 1;
      if (lower >= upper) continue;
      if (sides_.sign_on(k, lower, upper) != sign) return false;
      const bool is_whole = lower == 0 && upper == 1;
      if (is_whole ? !std::ranges::all_of(sides_.corners_[k],
                                          [&](const PlaneBall& x) { return is_ahead(x); })
                   : !is_ahead(sides_.along(k, lower, upper)))
        return false;
    }
    return true;
  }

 private:
  /// The tree looks along z, from where x is the second axis and −y the first one.
  static PlaneBall tangent(const CurveNode& arc, const SideFoot& foot) {
    const RealBall sign(foot.is_reversed ? -1 : 1, side_bits);
    return {multiply(sign, ball_of(arc.direction[1]), side_bits),
            subtract({}, multiply(sign, ball_of(arc.direction[0]), side_bits), side_bits)};
  }

  const TwoSides& sides_;
  PlaneBall a_;
  PlaneBall b_;
};

TwoSides::TwoSides(const PhPath& path, std::vector<std::optional<SideFoot>> feet)
    : feet_(std::move(feet)), is_closed_(path.closing_turn().has_value()) {
  for (const Curve& curve : path.segments()) {
    const PlaneTangent tangent = plane_tangent(curve);
    tangents_.push_back({tangent.x, tangent.y, {}});
    Stretches stretches{sign_after_zero(curve.multiplier()), {}};
    for (const RealAlgebraic& t : sign_changes(curve.multiplier()))
      stretches.breaks.push_back(doubles_around(enclose(t, side_bits)));
    stretches_.push_back(std::move(stretches));
    const long degree = std::max(tangent.x.degree(), tangent.y.degree());
    const std::vector<Rational> x = to_bernstein(tangent.x, degree);
    const std::vector<Rational> y = to_bernstein(tangent.y, degree);
    auto& corners = corners_.emplace_back();
    for (std::size_t k = 0; k < x.size(); ++k)
      corners.push_back({RealBall(x[k], side_bits), RealBall(y[k], side_bits)});
  }
}

PlaneBall TwoSides::along(std::size_t segment, double from, double to) const {
  const RealBall all = hull(exact_sum(from, 0), exact_sum(to, 0), 2 * side_bits);
  const RealBall middle = midpoint_of(all);
  const RealBall step = subtract(all, middle, side_bits);
  PlaneBall e;
  for (std::size_t k = 0; k < 2; ++k) {
    const Polynomial& x = tangents_[segment][k];
    e[k] = add_product(evaluate(x, middle, side_bits),
                       taylor_series(x, all, 2, side_bits).coefficient(1), step, side_bits);
  }
  return e;
}

int TwoSides::sign_on(std::size_t segment, double from, double to) const {
  int sign = stretches_[segment].first_sign;
  for (const DoubleInterval& at : stretches_[segment].breaks) {
    if (at.lower > to) break;
    if (at.upper >= from) return 0;
    sign = -sign;
  }
  return sign;
}

bool TwoSides::are_apart(const CurveNode& a, const CurveNode& b) const {
  const auto& at_a = feet_[a.first_segment];
  const auto& at_b = feet_[b.first_segment];
  if (!at_a || !at_b) return false;
  const Pair pair(*this, a, *at_a, b, *at_b);
  // What is beside each foot counts, too, where the arc is along the path.
  if (!at_a->point && !pair.is_ahead(pair.first())) return false;
  if (!at_b->point && !pair.is_ahead(pair.second())) return false;
  const FootRange p = range_of(*at_a, a);
  const FootRange q = range_of(*at_b, b);
  const int sign = sign_on(p.segment, p.from, p.to);
  if (sign == 0 || sign != sign_on(q.segment, q.from, q.to)) return false;
  const bool is_in_order = p.segment != q.segment ? p.segment < q.segment : p.from <= q.from;
  const FootRange& one = is_in_order ? p : q;
  const FootRange& other = is_in_order ? q : p;
  if (pair.is_ahead(one.segment, one.to, other.segment, other.from, sign)) return true;
  return is_closed_ && one.segment != other.segment &&
         pair.is_ahead(other.segment, other.to, stretches_.size() - 1, 1, sign) &&
         pair.is_ahead(0, 0, one.segment, one.from, sign);
}

}  // namespace phrame
