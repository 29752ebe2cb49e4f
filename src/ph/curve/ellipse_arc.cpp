#include "phrame/ph/curve/ellipse_arc.hpp"

#include <algorithm>

#include "phrame/algebra/rounding.hpp"

// On the unit circle: from p to q, with an angle φ < π between them, the tangents meet at
// (p + q)/(1 + cos φ), and the weights 1, k, k with k = cos²(φ/2) = (1 + cos φ)/2 make the arc of
// the three points, since w₁² = k w₀w₂: fractions, unlike the usual 1, cos(φ/2), 1.

namespace phrame::inline v0 {
namespace {

PlaneVector plane_sum(const PlaneVector& a, const Rational& c, const PlaneVector& b) {
  return {a[0] + c * b[0], a[1] + c * b[1]};
}
/// By a right angle.
PlaneVector quarter_turned(const PlaneVector& a) { return {-a[1], a[0]}; }
/// a·b as complex numbers.
PlaneVector turned_by(const PlaneVector& a, const PlaneVector& b) {
  return {a[0] * b[0] - a[1] * b[1], a[0] * b[1] + a[1] * b[0]};
}

/// The multiple of 2^−ellipse_bits next to the middle.
Rational short_middle(const RealBall& x) {
  return Rational(floor(x.midpoint() * power_of_two(ellipse_bits) + Rational(1, 2))) *
         power_of_two(-ellipse_bits);
}

/// i^quarters · (cos, sin)(rest), |rest| ≤ π/4 or so.
PlaneVector near_rotation(const Integer& quarters, const RealBall& rest) {
  constexpr long bits = ellipse_bits + 60;
  const auto [cosine, sine] = cos_sin(times_power_of_two(rest, -1), bits);
  const Rational tangent = short_middle(divide(sine, cosine, bits));
  const Rational square = tangent * tangent;
  PlaneVector result{(1 - square) / (1 + square), 2 * tangent / (1 + square)};
  const Rational turns = Rational(quarters) / 4;
  for (Rational k = 4 * (turns - Rational(floor(turns))); k > 0; k -= 1)
    result = quarter_turned(result);
  return result;
}

Vector<Rational> on_ellipse(const Ellipse& ellipse, const PlaneVector& p) {
  const PlaneVector q = plane_sum(plane_sum(ellipse.center, p[0], ellipse.a), p[1], ellipse.b);
  return {q[0], q[1], 0};
}

/// p to q on the unit circle, an angle < π.
RationalBezier short_arc(const Ellipse& ellipse, const PlaneVector& p, const PlaneVector& q) {
  const Rational k = (1 + plane_dot(p, q)) / 2;
  const Rational factor = 1 / (2 * k);
  const PlaneVector middle{factor * (p[0] + q[0]), factor * (p[1] + q[1])};
  return {{on_ellipse(ellipse, p), on_ellipse(ellipse, middle), on_ellipse(ellipse, q)}, {1, k, k}};
}

}  // namespace

Rational plane_dot(const PlaneVector& a, const PlaneVector& b) { return a[0] * b[0] + a[1] * b[1]; }
Rational plane_cross(const PlaneVector& a, const PlaneVector& b) {
  return a[0] * b[1] - a[1] * b[0];
}

Rational near_root(const Rational& x) {
  if (const auto root = square_root(x)) return *root;
  constexpr long places = ellipse_bits + 20;
  const Rational unit = power_of_two(binary_exponent(x) / 2 - places);
  return Rational(floor(sqrt(RealBall(x, 2 * places), 2 * places).midpoint() / unit)) * unit;
}

PlaneVector near_direction(const PlaneVector& v) {
  const Rational square = plane_dot(v, v);
  const auto exact = square_root(square);
  // tan(φ/2) = y/(r + |x|)
  Rational tangent = v[1] / ((exact ? *exact : near_root(square)) + abs(v[0]));
  if (!exact) tangent = short_middle(RealBall(tangent, 2 * ellipse_bits));
  const Rational below = 1 + tangent * tangent;
  const Rational x = (1 - tangent * tangent) / below;
  return {v[0] < 0 ? Rational(-x) : x, 2 * tangent / below};
}

PlaneVector rotation_by_degrees(const Rational& degrees) {
  const Integer quarters = floor(degrees / 90 + Rational(1, 2));
  const Rational rest = (degrees - 90 * Rational(quarters)) / 180;
  constexpr long bits = ellipse_bits + 60;
  return near_rotation(quarters, multiply(pi(bits), RealBall(rest, bits), bits));
}

PlaneVector rotation_by_radians(const Rational& angle) {
  const long bits = ellipse_bits + 60 + (angle == 0 ? 0 : std::max(0L, binary_exponent(angle)));
  const RealBall right_angle = times_power_of_two(pi(bits), -1);
  const RealBall quotient = divide(RealBall(angle, bits), right_angle, bits);
  const Integer quarters = floor(quotient.midpoint() + Rational(1, 2));
  const RealBall part = subtract(quotient, RealBall(Rational(quarters), bits), bits);
  const Rational tolerance =
      power_of_two(-48) * std::max(Rational(1), Rational(abs(Rational(quarters))));
  if (abs(part.midpoint()) < tolerance && quarters != 0) return near_rotation(quarters, RealBall());
  return near_rotation(quarters, multiply(part, right_angle, bits));
}

std::vector<RationalBezier> ellipse_arc(const Ellipse& ellipse, const PlaneVector& from,
                                        const PlaneVector& to, bool is_growing) {
  // A falling angle is one that grows, with y = −y′.
  if (!is_growing) {
    const Ellipse mirrored{ellipse.center, ellipse.a, {-ellipse.b[0], -ellipse.b[1]}};
    return ellipse_arc(mirrored, {from[0], -from[1]}, {to[0], -to[1]}, true);
  }
  std::vector<RationalBezier> arcs;
  PlaneVector p = from;
  for (bool is_first = true;; is_first = false) {
    const PlaneVector left = turned_by({p[0], -p[1]}, to);  // the angle that is left, in (0, 2π]
    if (!is_first && left == PlaneVector{1, 0}) return arcs;
    if (left[0] >= 0 && left[1] > 0) {
      arcs.push_back(short_arc(ellipse, p, to));
      return arcs;
    }
    const PlaneVector next = quarter_turned(p);
    arcs.push_back(short_arc(ellipse, p, next));
    p = next;
  }
}

std::vector<RationalBezier> ellipse_arc(const EndpointArc& arc) {
  const auto& [from, to, semiaxes, axis, is_large, is_growing] = arc;
  const PlaneVector a{semiaxes[0] * axis[0], semiaxes[0] * axis[1]};
  const PlaneVector b{-semiaxes[1] * axis[1], semiaxes[1] * axis[0]};
  // x·a + y·b = v, a ⟂ b.
  const auto on_circle = [&](const PlaneVector& v) {
    return PlaneVector{plane_dot(v, a) / plane_dot(a, a), plane_dot(v, b) / plane_dot(b, b)};
  };
  // In units of the semiaxes the chord is d, and the center q/2·|d| to its left or right.
  const PlaneVector d = on_circle(plane_sum(to, -1, from));
  const Rational square = 4 / plane_dot(d, d) - 1;
  Rational q;
  if (square > 0) {
    const auto root = square_root(square);
    const long bits = ellipse_bits + 60 + std::max(0L, -binary_exponent(square));
    q = root ? *root : short_middle(sqrt(RealBall(square, bits), bits));
  }
  // The sign of an axis is one of the angle.
  const bool turns_left = is_growing == (semiaxes[0].sign() * semiaxes[1].sign() > 0);
  const Rational to_left = (turns_left == is_large ? -1 : 1) * q / 2;
  // Seen from the center; of length √(1 + q²)·|d|/2, by which the axes are too short.
  const PlaneVector normal = quarter_turned(d);
  const PlaneVector to_center = plane_sum({d[0] / 2, d[1] / 2}, to_left, normal);
  const PlaneVector p{-to_center[0], -to_center[1]};
  const PlaneVector r = plane_sum(d, -1, to_center);
  const PlaneVector center = plane_sum(plane_sum(from, to_center[0], a), to_center[1], b);
  // The circle through p and r, of which p is taken for (1, 0).
  const PlaneVector p_turned = quarter_turned(p);
  const Rational size = plane_dot(p, p);
  const Ellipse ellipse{center, plane_sum({p[0] * a[0], p[0] * a[1]}, p[1], b),
                        plane_sum({p_turned[0] * a[0], p_turned[0] * a[1]}, p_turned[1], b)};
  return ellipse_arc(ellipse, {1, 0}, {plane_dot(p, r) / size, plane_dot(p_turned, r) / size},
                     turns_left);
}

}  // namespace phrame
