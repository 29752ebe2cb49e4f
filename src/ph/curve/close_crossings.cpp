// As in crossings.cpp, but with balls for doubles, and across a circle. Branches of one curvature
// may nearly coincide: next to a near-cusp all go along the circle of the radius |d| about it. Seen
// along the normal of one an arc of length h is h² thick; across its circle of curvature, h³. So
// points P are told by
//   x = v·(P − A),   y = v × (P − A) − ½k·|P − A|²,
// with the point A of an arc, the derivative v there and k for the curvature along v: y = 0 is
// that circle. Then arcs of length h have to be looked at which are as near as h to the place
// where branches nearly touch, so that their number is bounded at each h. x and y tell points from
// each other where k·(v × (P − A)) < |v|², on the same side of the line through the center along v.
#include "phrame/ph/curve/close_crossings.hpp"

#include <algorithm>
#include <cmath>

#include "phrame/algebra/ball_order.hpp"
#include "phrame/ph/curve/curve_arc.hpp"
#include "phrame/ph/curve/plane_ball.hpp"

namespace phrame::inline v0 {
namespace {

constexpr long deepest = 64;
constexpr long most_close_bits = 4096;
constexpr long fewest_terms = 6;
constexpr long most_terms = 96;
constexpr long most_close_pairs = 4000;
constexpr long most_pairs_of_all = 100'000;

/// An arc by its middle: its derivatives are v + h·b.
struct ArcSlope {
  PlaneBall point;  ///< in the middle
  PlaneBall v;      ///< the derivative there
  PlaneBall b;      ///< all second derivatives
  RealBall h;       ///< all differences from the parameter there
};

ArcSlope slope_of(const PlanePosition& position, std::size_t segment, const RealBall& t,
                  long bits) {
  const RealBall middle = midpoint_of(t);
  const auto there = position(segment, middle, 2, bits);
  const auto over = position(segment, t, 3, bits);
  ArcSlope slope;
  for (std::size_t k = 0; k < 2; ++k) {
    slope.point[k] = there[k].coefficient(0);
    slope.v[k] = there[k].coefficient(1);
    slope.b[k] = times_power_of_two(over[k].coefficient(2), 1);
  }
  slope.h = subtract(t, middle, bits);
  return slope;
}

/// @{ With all derivatives.
RealBall cross(const PlaneBall& a, const ArcSlope& b, long bits) {
  return add_product(cross(a, b.v, bits), b.h, cross(a, b.b, bits), bits);
}
RealBall cross(const ArcSlope& a, const ArcSlope& b, long bits) {
  return add_product(cross(a.v, b, bits), a.h, cross(a.b, b, bits), bits);
}
/// @}

/// P′(s)·ds − P′(t)·dt = −gap, by Cramer's rule.
NewtonStep newton(const ArcSlope& a, const RealBall& s, const ArcSlope& b, const RealBall& t,
                  long bits) {
  const PlaneBall gap = difference(a.point, b.point, bits);
  const RealBall determinant = cross(a, b, bits);
  const RealBall ds = divide(cross(gap, b, bits), determinant, bits);
  const RealBall dt = divide(cross(gap, a, bits), determinant, bits);
  return {subtract(midpoint_of(s), ds, bits), subtract(midpoint_of(t), dt, bits)};
}

PlaneBall coefficient(const PlaneSeries& p, long k) {
  return {p[0].coefficient(k), p[1].coefficient(k)};
}

/// [lower, upper] of a segment.
struct CloseArc {
  std::size_t segment;
  Rational lower;
  Rational upper;
  long bits;
  long terms = 0;
  PlaneSeries middle = {};  ///< around the middle, of so many terms
  PlaneSeries all = {};     ///< around all points of the arc, of one more
  RealBall h = {};          ///< all differences from the parameter in the middle
};

Rational width(const CloseArc& arc) { return arc.upper - arc.lower; }
/// About that. Where one is much faster than the other by its parameter, arcs of one width are not
/// of one length.
double length(const CloseArc& arc) {
  const auto& [x, y] = coefficient(arc.middle, 1);
  return static_cast<double>(width(arc)) * std::hypot(approximate(x), approximate(y));
}
/// How many bits of its reach the terms of the arc tell.
long bits_told(const CloseArc& arc) {
  const auto exponent = [&](long n) {
    const auto& [x, y] = coefficient(arc.all, n);
    return std::max(exponent_above(x), exponent_above(y)) + n * exponent_above(arc.h);
  };
  return exponent(1) - exponent(arc.terms);
}
RealBall parameter(const CloseArc& arc) { return hull(arc.lower, arc.upper, arc.bits); }

/// The x and y of points, with A in the middle of an arc. A, v and k are exact.
class CircleChart {
 public:
  CircleChart(const CloseArc& arc, long bits)
      : bits_(bits), at_(exact(coefficient(arc.middle, 0))), v_(exact(coefficient(arc.middle, 1))) {
    square_ = dot(v_, v_, bits_);
    const RealBall bend = times_power_of_two(cross(v_, coefficient(arc.middle, 2), bits_), 1);
    const RealBall k = divide(bend, square_, bits_);
    k_ = k.is_finite() ? midpoint_of(k) : RealBall();
  }

  /// x and y of an arc.
  ArcSlope seen(const CloseArc& arc) const {
    const PlaneSeries there = seen(arc.middle, arc.terms);
    const PlaneSeries over = seen(arc.all, arc.terms + 1);
    ArcSlope slope{coefficient(there, 0), coefficient(there, 1), {}, arc.h};
    for (std::size_t k = 0; k < 2; ++k) {
      RealBall& b = slope.b[k];
      b = over[k].coefficient(arc.terms);
      b = multiply(b, RealBall(arc.terms * (arc.terms - 1), 64), bits_);
      for (long n = arc.terms - 1; n >= 2; --n)
        b = add(multiply(b, arc.h, bits_),
                multiply(there[k].coefficient(n), RealBall(n * (n - 1), 64), bits_), bits_);
    }
    return slope;
  }

  /// Do x and y tell the points of the arc from each other, and from those of all such arcs?
  bool tells_points_of(const CloseArc& arc) const {
    return is_less(
        multiply(k_, cross(v_, difference(coefficient(arc.all, 0), at_, bits_), bits_), bits_),
        square_);
  }

 private:
  static PlaneBall exact(const PlaneBall& v) { return {midpoint_of(v[0]), midpoint_of(v[1])}; }

  PlaneSeries seen(PlaneSeries p, long length) const {
    for (std::size_t k = 0; k < 2; ++k)
      p[k] = with_constant(p[k], subtract(p[k].coefficient(0), at_[k], bits_));
    const BallPolynomial squares = add(multiply_series(p[0], p[0], length, bits_),
                                       multiply_series(p[1], p[1], length, bits_), bits_);
    const BallPolynomial across =
        subtract(multiply(v_[0], p[1], bits_), multiply(v_[1], p[0], bits_), bits_);
    return {add(multiply(v_[0], p[0], bits_), multiply(v_[1], p[1], bits_), bits_),
            subtract(across, multiply(times_power_of_two(k_, -1), squares, bits_), bits_)};
  }

  long bits_;
  PlaneBall at_;
  PlaneBall v_;
  RealBall square_;  ///< |v|²
  RealBall k_;
};

/// Two parts and all parts of them.
class ClosePair {
 public:
  ClosePair(const CurveSeries& curve, const PlanePosition& position)
      : curve_(curve), position_(position) {}

  bool find(const CurvePart& a, const CurvePart& b) { return visit(arc(a), arc(b)); }
  long pairs() const { return pairs_; }
  std::vector<Crossing> found() && { return std::move(found_); }

 private:
  CloseArc arc(const CurvePart& part) const {
    return arc(part.segment, exact_sum(part.lower, 0).midpoint(),
               exact_sum(part.upper, 0).midpoint());
  }

  CloseArc arc(std::size_t segment, const Rational& lower, const Rational& upper,
               long bits = 0) const {
    CloseArc arc{segment, lower, upper, std::max(bits, 96 - 4 * binary_exponent(upper - lower))};
    const RealBall t = parameter(arc);
    const RealBall middle = midpoint_of(t);
    arc.h = subtract(t, middle, arc.bits);
    // Each tells log₂(ρ/h) bits, with the distance ρ of the poles, as soon as these are seen.
    const long most = std::clamp(arc.bits / 4, fewest_terms, most_terms);
    for (long terms = fewest_terms; arc.terms < most;) {
      arc.terms = std::min(terms, most);
      arc.all = position_(segment, t, arc.terms + 1, arc.bits);
      const long told = bits_told(arc);
      if (told >= arc.bits - 64) break;
      terms = std::max(2 * terms, arc.terms * arc.bits / std::max(told, 1L));
    }
    arc.middle = position_(segment, middle, arc.terms, arc.bits);
    return arc;
  }

  /// Two arcs by their x or y.
  struct Gap {
    RealBall of_middles;
    RealBall reach;  ///< how far both go from these, taken together

    Gap(const ArcSlope& a, const ArcSlope& b, std::size_t k, long bits)
        : of_middles(absolute(subtract(a.point[k], b.point[k], bits))) {
      for (const ArcSlope* arc : {&a, &b})
        reach = add(reach,
                    multiply(absolute(add_product(arc->v[k], arc->h, arc->b[k], bits)),
                             absolute(arc->h), bits),
                    bits);
    }
    bool is_seen() const { return is_less(reach, of_middles); }
    /// Are the middles known to fewer bits than shorter arcs tell from each other?
    bool is_blurred() const { return is_less(reach, times_power_of_two(radius_of(of_middles), 6)); }
  };

  bool visit(const CloseArc& a, const CloseArc& b) {
    if (++pairs_ > most_close_pairs) return false;
    const long bits = std::max(a.bits, b.bits);
    const CircleChart chart(a, bits);
    const ArcSlope of_a = chart.seen(a);
    const ArcSlope of_b = chart.seen(b);
    const Gap across(of_a, of_b, 1, bits);
    if (across.is_seen() || Gap(of_a, of_b, 0, bits).is_seen()) return true;
    if (across.is_blurred() && bits < most_close_bits) {
      const auto again = [&](const CloseArc& x) {
        return arc(x.segment, x.lower, x.upper, 2 * bits);
      };
      return visit(again(a), again(b));
    }
    const CircleChart other(b, bits);
    if (Gap(other.seen(a), other.seen(b), 1, bits).is_seen()) return true;
    const RealBall determinant = cross(of_a, of_b, bits);
    if (determinant.contains_zero()) return visit_halves(a, b);
    const NewtonStep step = newton(of_a, parameter(a), of_b, parameter(b), bits);
    const auto is_outside = [](const RealBall& t, const CloseArc& arc) {
      return t.is_finite() && (t.upper() < arc.lower || t.lower() > arc.upper);
    };
    const auto is_inside = [](const RealBall& t, const CloseArc& arc) {
      return t.is_finite() && t.lower() > arc.lower && t.upper() < arc.upper;
    };
    if (is_outside(step.first, a) || is_outside(step.second, b)) return true;
    if (!is_inside(step.first, a) || !is_inside(step.second, b) || !chart.tells_points_of(a) ||
        !chart.tells_points_of(b))
      return visit_halves(a, b);
    found_.push_back(
        narrowed({a.segment, step.first, b.segment, step.second, phrame::sign(determinant)}, bits));
    return true;
  }

  /// By steps about circles, until those in x and y are told which way the branches cross.
  Crossing narrowed(Crossing crossing, long bits) const {
    while (bits <= most_close_bits) {
      const auto& [first, s, second, t, sign] = crossing;
      const CloseArc a = arc(first, s.lower(), s.upper(), bits);
      const CloseArc b = arc(second, t.lower(), t.upper(), bits);
      bits = std::max(a.bits, b.bits);
      if (!cross(slope_of(position_, first, s, bits), slope_of(position_, second, t, bits), bits)
               .contains_zero()) {
        std::tie(crossing.first_t, crossing.second_t) = phrame::narrowed(curve_, crossing, bits);
        return crossing;
      }
      const CircleChart chart(a, bits);
      const NewtonStep step = newton(chart.seen(a), s, chart.seen(b), t, bits);
      const auto is_nearer = [](const RealBall& now, const RealBall& before) {
        return now.is_finite() &&
               exponent_above(radius_of(now)) < exponent_above(radius_of(before));
      };
      if (is_nearer(step.first, s) && is_nearer(step.second, t))
        std::tie(crossing.first_t, crossing.second_t) = std::pair(step.first, step.second);
      else
        bits *= 2;
    }
    return crossing;
  }

  bool visit_halves(const CloseArc& a, const CloseArc& b) {
    const CloseArc& longer = length(a) >= length(b) ? a : b;
    if (width(longer) < power_of_two(-deepest)) return false;
    const Rational cut = longer.lower + width(longer) * Rational(31, 64);
    const CloseArc one = arc(longer.segment, longer.lower, cut, longer.bits);
    const CloseArc other = arc(longer.segment, cut, longer.upper, longer.bits);
    if (&longer == &a) return visit(one, b) && visit(other, b);
    return visit(a, one) && visit(a, other);
  }

  const CurveSeries& curve_;
  const PlanePosition& position_;
  long pairs_ = 0;
  std::vector<Crossing> found_;
};

bool are_same(const Crossing& a, const Crossing& b) {
  return a.first_segment == b.first_segment && a.second_segment == b.second_segment &&
         a.first_t.overlaps(b.first_t) && a.second_t.overlaps(b.second_t);
}

}  // namespace

bool goes_on_into(const CurveSeries& curve, std::size_t a, std::size_t b) {
  return (curve.behind.empty() ? (a + 1) % curve.segments : curve.behind[a]) == b;
}

bool are_joined(const CurveSeries& curve, const CurvePart& a, const CurvePart& b) {
  if (a.segment == b.segment && a.lower <= b.upper && b.lower <= a.upper) return true;
  const auto goes_on = [&](const CurvePart& x, const CurvePart& y) {
    return x.upper == 1 && y.lower == 0 && goes_on_into(curve, x.segment, y.segment);
  };
  return goes_on(a, b) || goes_on(b, a);
}

NewtonStep newton(const PlanePosition& p, std::size_t first, const RealBall& s,
                  const PlanePosition& q, std::size_t second, const RealBall& t, long bits) {
  return newton(slope_of(p, first, s, bits), s, slope_of(q, second, t, bits), t, bits);
}

PlanePosition plane_position(const CurveSeries& curve) {
  return
      [position = curve.position](std::size_t segment, const RealBall& t, long length, long bits) {
        const Vector<BallPolynomial> r = position(segment, t, length, bits);
        return std::array{r[0], r[1]};
      };
}

std::pair<RealBall, RealBall> narrowed(const CurveSeries& curve, const Crossing& crossing,
                                       long bits) {
  const PlanePosition position = plane_position(curve);
  const long working = bits + 64;
  RealBall s = crossing.first_t;
  RealBall t = crossing.second_t;
  // Each step doubles the digits; where it does not, they are as good as the numbers allow.
  for (long steps = 0; steps < 40 && !(s.is_accurate(bits) && t.is_accurate(bits)); ++steps) {
    const NewtonStep step =
        newton(position, crossing.first_segment, s, position, crossing.second_segment, t, working);
    if (!step.first.is_finite() || !step.second.is_finite()) break;
    s = step.first;
    t = step.second;
  }
  return {s, t};
}

void add_once(std::vector<Crossing>& found, const Crossing& crossing) {
  if (std::ranges::any_of(found, [&](const Crossing& x) { return are_same(crossing, x); })) return;
  const auto is_behind = [&](const Crossing& x) {
    return x.first_segment != crossing.first_segment
               ? x.first_segment > crossing.first_segment
               : x.first_t.midpoint() > crossing.first_t.midpoint();
  };
  found.insert(std::ranges::find_if(found, is_behind), crossing);
}

CloseSearch::CloseSearch(const CurveSeries& curve)
    : curve_(curve), position_(plane_position(curve)), pairs_left_(most_pairs_of_all) {}

std::optional<std::vector<Crossing>> CloseSearch::crossings(const CurvePart& a,
                                                            const CurvePart& b) {
  if (pairs_left_ <= 0) return std::nullopt;
  ClosePair pair(curve_, position_);
  const bool are_told = pair.find(a, b);
  pairs_left_ -= pair.pairs();
  return are_told ? std::optional(std::move(pair).found()) : std::nullopt;
}

void look_closer(const CurveSeries& curve, SelfIntersections& result) {
  if (result.is_cut_off) return;
  CloseSearch search(curve);
  std::erase_if(result.undecided, [&](const UndecidedCrossing& x) {
    if (are_joined(curve, x.first, x.second)) return false;
    const auto found = search.crossings(x.first, x.second);
    if (!found) return false;
    for (const Crossing& crossing : *found) add_once(result.found, crossing);
    return true;
  });
}

}  // namespace phrame
