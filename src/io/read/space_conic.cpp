#include "phrame/io/read/space_conic.hpp"

#include "phrame/algebra/elementary.hpp"
#include "phrame/algebra/error.hpp"
#include "phrame/io/read/plane_conic.hpp"
#include "phrame/ph/curve/vector.hpp"

namespace phrame::inline v0 {
namespace {

Vector<Rational> in_space(const SpaceConic& conic, const Vector<Rational>& p) {
  return conic.center + p[0] * conic.x + p[1] * conic.y;
}

CurvePieces in_space(const SpaceConic& conic, CurvePieces pieces) {
  for (RationalBezier& piece : pieces)
    for (Vector<Rational>& p : piece.points) p = in_space(conic, p);
  return pieces;
}

/// In the coordinates x and y, where the conic is that of these coefficients.
RationalBezier open_arc_between(const SpaceConic& conic, const PlaneConic& plane, bool is_parabola,
                                const Vector<Rational>& from, const Vector<Rational>& to) {
  const auto in_plane = [&](const Vector<Rational>& place) {
    const Vector<Rational> out = place - conic.center;
    const PlaneVector p{dot(out, conic.x), dot(out, conic.y)};
    const PlaneVector q = moved_onto(plane, p);
    if (!points_meet(place, in_space(conic, {q[0], q[1], 0})) || (!is_parabola && q[0] <= 0))
      throw InputError("an end is not on the curve");
    return p;
  };
  CurvePieces pieces =
      in_space(conic, {open_arc(plane, is_parabola, in_plane(from), in_plane(to))});
  pieces.front().points.front() = from;
  pieces.front().points.back() = to;
  return pieces.front();
}

}  // namespace

RationalBezier hyperbola_between(const SpaceConic& conic, const Vector<Rational>& from,
                                 const Vector<Rational>& to) {
  const auto& [a, b] = conic.semiaxes;
  return open_arc_between(conic, {1 / (a * a), 0, -1 / (b * b), 0, 0, -1}, false, from, to);
}

RationalBezier parabola_between(const SpaceConic& conic, const Vector<Rational>& from,
                                const Vector<Rational>& to) {
  return open_arc_between(conic, {0, 0, 1, -4 * conic.semiaxes[0], 0, 0}, true, from, to);
}

Vector<Rational> on_parabola(const SpaceConic& conic, const Rational& u) {
  const Rational& a = conic.semiaxes[0];
  return in_space(conic, {a * u * u, 2 * a * u, 0});
}

Vector<Rational> on_hyperbola(const SpaceConic& conic, const Rational& u) {
  if (abs(u) > 1000) throw InputError("the parameter of a hyperbola is beyond 1000");
  constexpr long bits = ellipse_bits + 20;
  const Rational power = elementary("exp", Real(Rational(abs(u))), true).enclose(bits).midpoint();
  const Rational inverse = 1 / power;
  const auto& [a, b] = conic.semiaxes;
  return in_space(
      conic, {a * (power + inverse) / 2, b * (u < 0 ? inverse - power : power - inverse) / 2, 0});
}

Vector<Rational> near_unit(const Vector<Rational>& v) {
  const Rational square = dot(v, v);
  if (square == 0) throw InputError("a direction is 0");
  return Rational(1 / near_root(square)) * v;
}

SpaceConic conic_about(const Vector<Rational>& center, const Vector<Rational>& axis,
                       const Vector<Rational>& reference, const std::array<Rational, 2>& semiaxes) {
  for (const Rational& size : semiaxes)
    if (size <= 0) throw InputError("the radius is not > 0");
  if (dot(axis, axis) == 0) throw InputError("the axis is 0");
  const Vector<Rational> across =
      reference - Rational(dot(reference, axis) / dot(axis, axis)) * axis;
  if (dot(across, across) == 0) throw InputError("the reference direction is along the axis");
  const Vector<Rational> x = near_unit(across);
  return {center, semiaxes, x, near_unit(cross(axis, x))};
}

CurvePieces arc_between(const SpaceConic& conic, const PlaneVector& from, const PlaneVector& to,
                        bool is_growing) {
  const auto& [a, b] = conic.semiaxes;
  return in_space(conic, ellipse_arc(Ellipse{{0, 0}, {a, 0}, {0, b}}, from, to, is_growing));
}

CurvePieces arc_between(const SpaceConic& conic, const Vector<Rational>& from,
                        const Vector<Rational>& to, bool is_growing) {
  const auto& [a, b] = conic.semiaxes;
  const auto in_plane = [&, &a = a, &b = b](const Vector<Rational>& place) {
    const Vector<Rational> out = place - conic.center;
    const PlaneVector p{dot(out, conic.x), dot(out, conic.y)};
    const PlaneVector q = near_direction({p[0] / a, p[1] / b});
    if (!points_meet(place, in_space(conic, {a * q[0], b * q[1], 0})))
      throw InputError("an end is not on the curve");
    return p;
  };
  const PlaneVector p = in_plane(from);
  const PlaneVector q = in_plane(to);
  const Rational square = plane_dot(p, p);
  CurvePieces pieces;
  if (a == b && square == plane_dot(q, q)) {
    const PlaneVector end{plane_dot(p, q) / square, plane_cross(p, q) / square};
    pieces = ellipse_arc(Ellipse{{0, 0}, p, {-p[1], p[0]}}, {1, 0}, end, is_growing);
  } else if (points_meet(from, to)) {
    const PlaneVector start = near_direction({p[0] / a, p[1] / b});
    pieces = ellipse_arc(Ellipse{{0, 0}, {a, 0}, {0, b}}, start, start, is_growing);
  } else {
    const Rational turn = plane_cross(p, q) * (is_growing ? 1 : -1);
    pieces = ellipse_arc(EndpointArc{p, q, {a, b}, {1, 0}, turn < 0, is_growing});
  }
  pieces = in_space(conic, std::move(pieces));
  pieces.front().points.front() = from;
  pieces.back().points.back() = to;
  return pieces;
}

}  // namespace phrame
