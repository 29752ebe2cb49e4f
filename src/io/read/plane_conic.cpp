#include "phrame/io/read/plane_conic.hpp"

#include "phrame/algebra/error.hpp"

// Where the tangents at p and q meet in T, the conic between these is the arc of p, T, q with the
// weights 1, k, k if it vanishes on w₀(1−t)²p + 2w₁t(1−t)T + w₂t²q: the terms with t²(1−t)² say
// 4w₁²·c(T) + 2w₀w₂·c(p, q) = 0 with the symmetric form c(·, ·), so that k = w₁²/(w₀w₂) = −c(p,
// q)/(2c(T)): a fraction. It is 1 for parabolas, > 0 where p and q are on one branch [Farin, Curves
// and Surfaces for CAGD, 12.5].

namespace phrame::inline v0 {
namespace {

/// The symmetric form of which the conic is the square.
Rational form(const PlaneConic& c, const PlaneVector& p, const PlaneVector& q) {
  return c[0] * p[0] * q[0] + c[1] * (p[0] * q[1] + p[1] * q[0]) / 2 + c[2] * p[1] * q[1] +
         c[3] * (p[0] + q[0]) / 2 + c[4] * (p[1] + q[1]) / 2 + c[5];
}

PlaneVector gradient(const PlaneConic& c, const PlaneVector& p) {
  return {2 * c[0] * p[0] + c[1] * p[1] + c[3], c[1] * p[0] + 2 * c[2] * p[1] + c[4]};
}

PlaneVector difference(const PlaneVector& p, const PlaneVector& q) {
  return {p[0] - q[0], p[1] - q[1]};
}

Vector<Rational> in_space(const PlaneVector& p) { return {p[0], p[1], 0}; }

/// x with a·x = α and b·x = β; the determinant is not 0.
PlaneVector solution(const PlaneVector& a, const Rational& alpha, const PlaneVector& b,
                     const Rational& beta) {
  const Rational determinant = plane_cross(a, b);
  return {(alpha * b[1] - beta * a[1]) / determinant, (beta * a[0] - alpha * b[0]) / determinant};
}

}  // namespace

Rational discriminant(const PlaneConic& c) { return c[1] * c[1] - 4 * c[0] * c[2]; }

PlaneVector moved_onto(const PlaneConic& conic, const PlaneVector& p) {
  const PlaneVector g = gradient(conic, p);
  const Rational square = plane_dot(g, g);
  if (square == 0) throw InputError("an end is the center of the conic");
  const Rational step = form(conic, p, p) / square;
  return {p[0] - step * g[0], p[1] - step * g[1]};
}

RationalBezier open_arc(const PlaneConic& conic, bool is_parabola, const PlaneVector& from,
                        const PlaneVector& to) {
  const PlaneVector a = gradient(conic, from);
  const PlaneVector b = gradient(conic, to);
  if (plane_cross(a, b) == 0) throw InputError("its ends are one, or it has no arc between them");
  const PlaneVector middle = solution(a, plane_dot(a, from), b, plane_dot(b, to));
  RationalBezier arc{{in_space(from), in_space(middle), in_space(to)}};
  if (is_parabola) return arc;
  const Rational at_middle = form(conic, middle, middle);
  const Rational k =
      at_middle == 0 ? Rational() : Rational(-form(conic, from, to) / (2 * at_middle));
  if (k <= 0) throw InputError("its ends are not on one branch");
  if (k != 1) arc.weights = {1, k, k};
  return arc;
}

CurvePieces closed_arc(const PlaneConic& conic, const PlaneVector& from, const PlaneVector& to) {
  if (discriminant(conic) >= 0) throw InputError("it is no ellipse");
  const auto& [A, B, C, D, E, F] = conic;
  const PlaneVector center = solution({2 * A, B}, -D, {B, 2 * C}, -E);
  // Half of the diameter through the start, and half of that in the direction of the tangent there.
  const PlaneVector a = difference(from, center);
  const PlaneVector g = gradient(conic, from);
  PlaneVector b{-g[1], g[0]};
  const auto quadratic = [&](const PlaneVector& v) -> Rational {
    return conic[0] * v[0] * v[0] + conic[1] * v[0] * v[1] + conic[2] * v[1] * v[1];
  };
  const Rational turn = plane_cross(a, b);
  if (turn == 0) throw InputError("an end is the center of the conic");
  const Rational size = near_root(quadratic(a) / quadratic(b)) * (turn > 0 ? 1 : -1);
  b = {size * b[0], size * b[1]};
  const PlaneVector out = difference(to, center);
  const Rational area = plane_cross(a, b);
  const PlaneVector end =
      points_meet(in_space(from), in_space(to))
          ? PlaneVector{1, 0}
          : near_direction({plane_cross(out, b) / area, plane_cross(a, out) / area});
  CurvePieces pieces = ellipse_arc(Ellipse{center, a, b}, {1, 0}, end, true);
  pieces.front().points.front() = in_space(from);
  pieces.back().points.back() = in_space(to);
  return pieces;
}

}  // namespace phrame
