// As in crossings.cpp, but with balls for doubles. Near a place where two branches nearly touch,
// arcs of length h have to be looked at that are as near to it as h, so that their number is
// bounded at each h: seen along a normal the arcs are only h² thick.
#include "phrame/ph/curve/close_crossings.hpp"

#include <algorithm>

#include "phrame/algebra/ball_order.hpp"
#include "phrame/ph/curve/curve_arc.hpp"

namespace phrame::inline v0 {
namespace {

constexpr long deepest = 64;
constexpr long most_close_pairs = 4000;
constexpr long most_pairs_of_all = 100'000;

using PlaneBall = std::array<RealBall, 2>;

RealBall cross(const PlaneBall& a, const PlaneBall& b, long bits) {
  return subtract(multiply(a[0], b[1], bits), multiply(a[1], b[0], bits), bits);
}

struct CloseArc {
  std::size_t segment;
  Rational lower;
  Rational upper;
  long bits;
  PlaneBall middle;    ///< the point in the middle
  PlaneBall velocity;  ///< all derivatives on it
};

Rational width(const CloseArc& arc) { return arc.upper - arc.lower; }
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
    CloseArc arc{segment, lower, upper, 96 - 4 * binary_exponent(upper - lower), {}, {}};
    const RealBall all = parameter(arc);
    const RealBall middle = midpoint_of(all);
    const RealBall step = subtract(all, middle, arc.bits);
    const auto there = position_(segment, middle, 2, arc.bits);
    const auto over = position_(segment, all, 3, arc.bits);
    for (std::size_t k = 0; k < 2; ++k) {
      arc.middle[k] = there[k].coefficient(0);
      const RealBall bend = times_power_of_two(over[k].coefficient(2), 1);
      arc.velocity[k] = add_product(there[k].coefficient(1), bend, step, arc.bits);
    }
    return arc;
  }

  /// Are they apart, seen along a normal of a?
  static bool are_apart(const CloseArc& a, const CloseArc& b) {
    const long bits = std::max(a.bits, b.bits);
    if (!a.velocity[0].is_finite() || !a.velocity[1].is_finite()) return false;
    const PlaneBall along{midpoint_of(a.velocity[0]), midpoint_of(a.velocity[1])};
    const PlaneBall gap{subtract(a.middle[0], b.middle[0], bits),
                        subtract(a.middle[1], b.middle[1], bits)};
    const auto reach = [&](const CloseArc& arc) {
      return multiply(absolute(cross(along, arc.velocity, bits)), RealBall(width(arc) / 2, bits),
                      bits);
    };
    return is_less(add(reach(a), reach(b), bits), absolute(cross(along, gap, bits)));
  }

  bool visit(const CloseArc& a, const CloseArc& b) {
    if (++pairs_ > most_close_pairs) return false;
    if (are_apart(a, b) || are_apart(b, a)) return true;
    const long bits = std::max(a.bits, b.bits);
    if (cross(a.velocity, b.velocity, bits).contains_zero()) return visit_halves(a, b);
    const NewtonStep step =
        newton(position_, a.segment, parameter(a), position_, b.segment, parameter(b), bits);
    const auto is_outside = [](const RealBall& t, const CloseArc& arc) {
      return t.is_finite() && (t.upper() < arc.lower || t.lower() > arc.upper);
    };
    const auto is_inside = [](const RealBall& t, const CloseArc& arc) {
      return t.is_finite() && t.lower() > arc.lower && t.upper() < arc.upper;
    };
    if (is_outside(step.first, a) || is_outside(step.second, b)) return true;
    if (!is_inside(step.first, a) || !is_inside(step.second, b)) return visit_halves(a, b);
    const int sign = phrame::sign(cross(a.velocity, b.velocity, bits));
    Crossing crossing{a.segment, step.first, b.segment, step.second, sign};
    std::tie(crossing.first_t, crossing.second_t) = narrowed(curve_, crossing, bits);
    found_.push_back(std::move(crossing));
    return true;
  }

  bool visit_halves(const CloseArc& a, const CloseArc& b) {
    const CloseArc& longer = width(a) >= width(b) ? a : b;
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

/// Have they a point in common, as a part with itself has?
bool are_joined(const CurveSeries& curve, const CurvePart& a, const CurvePart& b) {
  if (a.segment == b.segment && a.lower <= b.upper && b.lower <= a.upper) return true;
  const auto goes_on = [&](const CurvePart& x, const CurvePart& y) {
    return x.upper == 1 && y.lower == 0 &&
           (curve.behind.empty() ? (x.segment + 1) % curve.segments : curve.behind[x.segment]) ==
               y.segment;
  };
  return goes_on(a, b) || goes_on(b, a);
}

bool are_same(const Crossing& a, const Crossing& b) {
  return a.first_segment == b.first_segment && a.second_segment == b.second_segment &&
         a.first_t.overlaps(b.first_t) && a.second_t.overlaps(b.second_t);
}

}  // namespace

NewtonStep newton(const PlanePosition& p, std::size_t first, const RealBall& s,
                  const PlanePosition& q, std::size_t second, const RealBall& t, long bits) {
  const RealBall near_s = midpoint_of(s);
  const RealBall near_t = midpoint_of(t);
  const auto at_s = p(first, near_s, 1, bits);
  const auto at_t = q(second, near_t, 1, bits);
  const auto over_s = p(first, s, 2, bits);
  const auto over_t = q(second, t, 2, bits);
  PlaneBall gap;
  PlaneBall slope_s;
  PlaneBall slope_t;
  for (std::size_t k = 0; k < 2; ++k) {
    gap[k] = subtract(at_s[k].coefficient(0), at_t[k].coefficient(0), bits);
    slope_s[k] = over_s[k].coefficient(1);
    slope_t[k] = over_t[k].coefficient(1);
  }
  // P′(s)·ds − P′(t)·dt = −gap, by Cramer's rule.
  const RealBall determinant = cross(slope_s, slope_t, bits);
  const RealBall ds = divide(cross(gap, slope_t, bits), determinant, bits);
  const RealBall dt = divide(cross(gap, slope_s, bits), determinant, bits);
  return {subtract(near_s, ds, bits), subtract(near_t, dt, bits)};
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

void look_closer(const CurveSeries& curve, SelfIntersections& result) {
  if (result.is_cut_off) return;
  CloseSearch search(curve, plane_position(curve));
  std::erase_if(result.undecided, [&](const UndecidedCrossing& x) {
    if (are_joined(curve, x.first, x.second)) return false;
    const auto found = search.crossings(x.first, x.second);
    if (!found) return false;
    for (const Crossing& crossing : *found) {
      if (std::ranges::any_of(result.found,
                              [&](const Crossing& y) { return are_same(crossing, y); }))
        continue;
      const auto is_behind = [&](const Crossing& y) {
        return y.first_segment != crossing.first_segment
                   ? y.first_segment > crossing.first_segment
                   : y.first_t.midpoint() > crossing.first_t.midpoint();
      };
      result.found.insert(std::ranges::find_if(result.found, is_behind), crossing);
    }
    return true;
  });
}

}  // namespace phrame
