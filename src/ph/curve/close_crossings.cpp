// As in crossings.cpp, but with balls for doubles. Near a place where two branches nearly touch,
// arcs of length h have to be looked at that are as near to it as h, so that their number is
// bounded at each h: seen along a normal the arcs are only h² thick. That is lost where all
// derivatives on an arc are put into a box, since the speed may change much while the curve turns
// by little: so what is across is taken of the derivative in the middle and of the second ones.
#include "phrame/ph/curve/close_crossings.hpp"

#include <algorithm>
#include <cmath>

#include "phrame/algebra/ball_order.hpp"
#include "phrame/ph/curve/curve_arc.hpp"
#include "phrame/ph/curve/plane_ball.hpp"

namespace phrame::inline v0 {
namespace {

constexpr long deepest = 64;
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

struct CloseArc {
  std::size_t segment;
  Rational lower;
  Rational upper;
  long bits;
  ArcSlope slope = {};
};

Rational width(const CloseArc& arc) { return arc.upper - arc.lower; }
/// About that. Where one is much faster than the other by its parameter, arcs of one width are not
/// of one length.
double length(const CloseArc& arc) {
  return static_cast<double>(width(arc)) *
         std::hypot(approximate(arc.slope.v[0]), approximate(arc.slope.v[1]));
}
RealBall parameter(const CloseArc& arc) { return hull(arc.lower, arc.upper, arc.bits); }

class CloseSearch {
 public:
  CloseSearch(const CurveSeries& curve, PlanePosition position)
      : curve_(curve), position_(std::move(position)) {}

  /// All crossings of two parts; no value where they are not told.
  std::optional<std::vector<Crossing>> crossings(const CurvePart& a, const CurvePart& b) {
    all_pairs_ += pairs_;
    pairs_ = 0;
    found_.clear();
    if (all_pairs_ > most_pairs_of_all || !visit(arc(a), arc(b))) return std::nullopt;
    return std::move(found_);
  }

 private:
  CloseArc arc(const CurvePart& part) const {
    return arc(part.segment, exact_sum(part.lower, 0).midpoint(),
               exact_sum(part.upper, 0).midpoint());
  }

  CloseArc arc(std::size_t segment, const Rational& lower, const Rational& upper) const {
    CloseArc arc{segment, lower, upper, 96 - 4 * binary_exponent(upper - lower)};
    arc.slope = slope_of(position_, segment, parameter(arc), arc.bits);
    return arc;
  }

  /// Are they apart, seen along a normal of a?
  static bool are_apart(const CloseArc& a, const CloseArc& b) {
    const long bits = std::max(a.bits, b.bits);
    const PlaneBall& along = a.slope.v;
    const PlaneBall gap = difference(a.slope.point, b.slope.point, bits);
    const auto reach = [&](const CloseArc& arc) {
      return multiply(absolute(cross(along, arc.slope, bits)), RealBall(width(arc) / 2, bits),
                      bits);
    };
    return is_less(add(reach(a), reach(b), bits), absolute(cross(along, gap, bits)));
  }

  bool visit(const CloseArc& a, const CloseArc& b) {
    if (++pairs_ > most_close_pairs) return false;
    if (are_apart(a, b) || are_apart(b, a)) return true;
    const long bits = std::max(a.bits, b.bits);
    const RealBall determinant = cross(a.slope, b.slope, bits);
    if (determinant.contains_zero()) return visit_halves(a, b);
    const NewtonStep step = newton(a.slope, parameter(a), b.slope, parameter(b), bits);
    const auto is_outside = [](const RealBall& t, const CloseArc& arc) {
      return t.is_finite() && (t.upper() < arc.lower || t.lower() > arc.upper);
    };
    const auto is_inside = [](const RealBall& t, const CloseArc& arc) {
      return t.is_finite() && t.lower() > arc.lower && t.upper() < arc.upper;
    };
    if (is_outside(step.first, a) || is_outside(step.second, b)) return true;
    if (!is_inside(step.first, a) || !is_inside(step.second, b)) return visit_halves(a, b);
    Crossing crossing{a.segment, step.first, b.segment, step.second, phrame::sign(determinant)};
    std::tie(crossing.first_t, crossing.second_t) = narrowed(curve_, crossing, bits);
    found_.push_back(std::move(crossing));
    return true;
  }

  bool visit_halves(const CloseArc& a, const CloseArc& b) {
    const CloseArc& longer = length(a) >= length(b) ? a : b;
    if (width(longer) < power_of_two(-deepest)) return false;
    const Rational cut = longer.lower + width(longer) * Rational(31, 64);
    const CloseArc one = arc(longer.segment, longer.lower, cut);
    const CloseArc other = arc(longer.segment, cut, longer.upper);
    if (&longer == &a) return visit(one, b) && visit(other, b);
    return visit(a, one) && visit(a, other);
  }

  const CurveSeries& curve_;
  PlanePosition position_;
  long pairs_ = 0;
  long all_pairs_ = 0;
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

void look_closer(const CurveSeries& curve, SelfIntersections& result) {
  if (result.is_cut_off) return;
  CloseSearch search(curve, plane_position(curve));
  std::erase_if(result.undecided, [&](const UndecidedCrossing& x) {
    if (are_joined(curve, x.first, x.second)) return false;
    const auto found = search.crossings(x.first, x.second);
    if (!found) return false;
    for (const Crossing& crossing : *found) add_once(result.found, crossing);
    return true;
  });
}

}  // namespace phrame
