#include "phrame/ph/offset/touching.hpp"

#include <algorithm>

#include "phrame/algebra/algebraic_image.hpp"
#include "phrame/algebra/ball_order.hpp"
#include "phrame/ph/curve/close_crossings.hpp"
#include "phrame/ph/curve/curve_arc.hpp"
#include "phrame/ph/curve/plane_ball.hpp"
#include "phrame/ph/curve/vector.hpp"

namespace phrame::inline v0 {
namespace {

constexpr long touching_bits = 512;

/// A curve up to its second derivative.
struct Jet {
  PlaneBall point;
  PlaneBall velocity;
  PlaneBall acceleration;
};

/// A part of a boundary curve.
struct PlanePart {
  const RationalCurve& curve;
  const CurveSeries& series;
  CurvePart part;
};

Jet jet_of(const PlanePart& of, const RealBall& t) {
  const auto r = plane_position(of.series)(of.part.segment, t, 3, touching_bits);
  Jet jet;
  for (std::size_t k = 0; k < 2; ++k) {
    jet.point[k] = r[k].coefficient(0);
    jet.velocity[k] = r[k].coefficient(1);
    jet.acceleration[k] = times_power_of_two(r[k].coefficient(2), 1);
  }
  return jet;
}

bool is_in(const RealAlgebraic& t, const CurvePart& part) {
  const Interval where = interval_of(part);
  return compare(t, *where.lower) >= 0 && compare(t, *where.upper) <= 0;
}

/// Where P′·(P − Q) = 0 and P′ × Q′ = 0, the simplest fractions there, by Newton's method from the
/// middles; whether they are right is not told.
std::optional<std::pair<Rational, Rational>> guess(const PlanePart& a, const PlanePart& b) {
  constexpr long most_steps = 12;
  RealBall s =
      midpoint_of(hull(*interval_of(a.part).lower, *interval_of(a.part).upper, touching_bits));
  RealBall t =
      midpoint_of(hull(*interval_of(b.part).lower, *interval_of(b.part).upper, touching_bits));
  for (long steps = 0; steps < most_steps; ++steps) {
    const Jet p = jet_of(a, s);
    const Jet q = jet_of(b, t);
    const PlaneBall gap = difference(p.point, q.point, touching_bits);
    const RealBall f = dot(p.velocity, gap, touching_bits);
    const RealBall g = cross(p.velocity, q.velocity, touching_bits);
    const RealBall fs = add(dot(p.acceleration, gap, touching_bits),
                            dot(p.velocity, p.velocity, touching_bits), touching_bits);
    const RealBall ft = subtract({}, dot(p.velocity, q.velocity, touching_bits), touching_bits);
    const RealBall gs = cross(p.acceleration, q.velocity, touching_bits);
    const RealBall gt = cross(p.velocity, q.acceleration, touching_bits);
    const PlaneBall of_s{fs, gs};
    const PlaneBall of_t{ft, gt};
    const RealBall determinant = cross(of_s, of_t, touching_bits);
    s = subtract(s, divide(cross({f, g}, of_t, touching_bits), determinant, touching_bits),
                 touching_bits);
    t = subtract(t, divide(cross(of_s, {f, g}, touching_bits), determinant, touching_bits),
                 touching_bits);
    if (!s.is_finite() || !t.is_finite()) return std::nullopt;
    s = midpoint_of(s);
    t = midpoint_of(t);
  }
  const auto simplest = [](const RealBall& x) {
    const Rational near = power_of_two(-touching_bits / 2);
    return simplest_between(x.midpoint() - near, x.midpoint() + near);
  };
  return std::pair(simplest(s), simplest(t));
}

/// All curvatures, seen along e, where all directions are; no value where they are not.
std::optional<RealBall> curvatures(const PlanePart& of, const PlaneBall& e) {
  const Interval all = interval_of(of.part);
  const Jet jet = jet_of(of, hull(*all.lower, *all.upper, touching_bits));
  const int side = sign(dot(e, jet.velocity, touching_bits));
  if (side == 0) return std::nullopt;
  const RealBall square = dot(jet.velocity, jet.velocity, touching_bits);
  const RealBall curvature =
      divide(cross(jet.velocity, jet.acceleration, touching_bits),
             multiply(square, sqrt(square, touching_bits), touching_bits), touching_bits);
  return side > 0 ? curvature : subtract({}, curvature, touching_bits);
}

std::optional<std::vector<KnownMeeting>> touching_at_fractions(const PlanePart& a,
                                                               const PlanePart& b) {
  const auto found = guess(a, b);
  if (!found) return std::nullopt;
  const auto& [s, t] = *found;
  if (!is_in(s, a.part) || !is_in(t, b.part)) return std::nullopt;
  const Vector<Rational> h = evaluate(a.curve.direction(), s);
  const Vector<Rational> k = evaluate(b.curve.direction(), t);
  if (point(a.curve, s) != point(b.curve, t) || h[0] * k[1] != h[1] * k[0]) return std::nullopt;
  const PlaneBall e{RealBall(h[0], touching_bits), RealBall(h[1], touching_bits)};
  const auto one = curvatures(a, e);
  const auto other = curvatures(b, e);
  if (!one || !other || !(is_less(*one, *other) || is_less(*other, *one))) return std::nullopt;
  return std::vector<KnownMeeting>{{a.part.segment, s, b.part.segment, t}};
}

/// `shift` + `factor`·s is the parameter of the image of P(s).
std::optional<std::vector<KnownMeeting>> touching_at_axis(const PlanePart& a, const PlanePart& b,
                                                          const Rational& shift,
                                                          const Rational& factor) {
  // The axis from the images of a point at either end.
  Vector<Rational> from;
  Vector<Rational> across;
  for (const Rational& s : {Rational(0), Rational(1)}) {
    from = point(a.curve, s);
    across = point(b.curve, shift + factor * s) - from;
    if (across != Vector<Rational>{}) break;
  }
  const Rational square = dot(across, across);
  if (square == 0) return std::nullopt;
  // g = (P − the middle)·across, times W.
  const Polynomial& weight = a.curve.weight();
  const auto& x = a.curve.numerator();
  const Polynomial gap =
      across[0] * x[0] + across[1] * x[1] - (dot(across, from) + square / 2) * weight;
  const Polynomial image{shift, factor};
  const Polynomial other_weight = compose(b.curve.weight(), image);
  for (std::size_t k = 0; k < 2; ++k)
    if ((x[k] - (2 * across[k] / square) * gap) * other_weight !=
        compose(b.curve.numerator()[k], image) * weight)
      return std::nullopt;
  // Both parts, as parameters of P.
  const Interval one = interval_of(a.part);
  const Interval other = interval_of(b.part);
  const Rational p = (*other.lower - shift) / factor;
  const Rational q = (*other.upper - shift) / factor;
  const auto roots =
      real_roots(gap, closed_interval(std::min({*one.lower, p, q}), std::max({*one.upper, p, q})));
  std::vector<KnownMeeting> found;
  for (const RealRoot& root : roots) {
    if (roots.size() > 1 || root.order % 2 != 0) return std::nullopt;
    const RealAlgebraic t = affine(root.at, factor, shift);
    if (is_in(root.at, a.part) && is_in(t, b.part))
      found.push_back({a.part.segment, root.at, b.part.segment, t});
  }
  return found;
}

}  // namespace

std::optional<std::vector<KnownMeeting>> touching(const OffsetBranches& offset,
                                                  const CurveSeries& series,
                                                  const UndecidedCrossing& place) {
  if (are_joined(series, place.first, place.second)) return std::nullopt;
  const PlanePart a{offset.curves[place.first.segment], series, place.first};
  const PlanePart b{offset.curves[place.second.segment], series, place.second};
  if (auto found = touching_at_fractions(a, b)) return found;
  if (auto found = touching_at_axis(a, b, 1, -1)) return found;
  return touching_at_axis(a, b, 0, 1);
}

}  // namespace phrame
