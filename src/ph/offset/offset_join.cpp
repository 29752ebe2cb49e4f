// The arc from the unit vector a to the unit vector b, by less than π: with c = a·b its tangents
// meet in m = (a + b)/(1 + c), |m|² = 2/(1 + c), and
//   n(t) = ((1 − t)²a + 2t(1 − t)m + t²k·b)/((1 − t)² + 2t(1 − t) + t²k),  k = 2/(1 + c),
// is that arc: with a·m = b·m = 1 the square of the numerator is that of the denominator. So it is
// rational where a and b are, though the usual weights 1, cos, 1 are not.
//
// An arc of 2π/3 or more is cut behind the angle of the triangle 7, 24, 25, 73.7°: what is left is
// between 46.2° and 106.3°.
#include "phrame/ph/offset/offset_join.hpp"

namespace phrame::inline v0 {
namespace {

Rational dot(const PlaneDirection& a, const PlaneDirection& b) { return a.x * b.x + a.y * b.y; }

/// at + d·n.
Vector<Rational> moved(const Vector<Rational>& at, const PlaneDirection& n, const Rational& d) {
  return {at[0] + d * n.x, at[1] + d * n.y, at[2]};
}

/// Where the tangents at two unit vectors meet.
PlaneDirection pole(const PlaneDirection& a, const PlaneDirection& b) {
  const Rational scale = 1 / (1 + dot(a, b));
  return {scale * (a.x + b.x), scale * (a.y + b.y)};
}

RationalCurve arc(const Vector<Rational>& center, const PlaneDirection& a, const PlaneDirection& b,
                  const Rational& d) {
  return bezier_curve({moved(center, a, d), moved(center, pole(a, b), d), moved(center, b, d)},
                      {1, 1, 2 / (1 + dot(a, b))});
}

std::vector<RationalCurve> arcs(const Vector<Rational>& center, const PlaneDirection& a,
                                const PlaneDirection& b, const Rational& d) {
  if (dot(a, b) > Rational(-1, 2)) return {arc(center, a, b, d)};
  const Rational cosine(7, 25);
  const Rational sine = cross(a, b) > 0 ? Rational(24, 25) : Rational(-24, 25);
  const PlaneDirection between{cosine * a.x - sine * a.y, sine * a.x + cosine * a.y};
  return {arc(center, a, between, d), arc(center, between, b, d)};
}

}  // namespace

bool is_outside(const PlaneCorner& corner, const Rational& d) {
  return corner.sign * d * cross(corner.before, corner.after) > 0;
}

std::vector<RationalCurve> corner_join(const PlaneCorner& corner, const Rational& d,
                                       OffsetJoin join) {
  const PlaneDirection a = right_normal(corner.before);
  const PlaneDirection b = right_normal(corner.after);
  std::vector<RationalCurve> pieces;
  if (join == OffsetJoin::round) pieces = arcs(corner.at, a, b, d);
  if (join == OffsetJoin::mitre) {
    const Vector<Rational> tip = moved(corner.at, pole(a, b), d);
    pieces = {bezier_curve({moved(corner.at, a, d), tip}),
              bezier_curve({tip, moved(corner.at, b, d)})};
  }
  if (corner.sign < 0)
    for (RationalCurve& piece : pieces) piece = piece.turned_over();
  return pieces;
}

std::vector<RationalCurve> circle_arcs(const Vector<Rational>& center, PlaneDirection a,
                                       const PlaneDirection& b, const Rational& radius) {
  std::vector<RationalCurve> found;
  const auto is_last = [&] { return cross(a, b) > 0 && dot(a, b) >= 0; };
  while (!is_last()) {
    const PlaneDirection left{-a.y, a.x};
    found.push_back(arc(center, a, left, radius));
    a = left;
  }
  found.push_back(arc(center, a, b, radius));
  return found;
}

std::vector<RationalCurve> end_cap(const Vector<Rational>& at, const PlaneDirection& e1, int sign,
                                   const Rational& d) {
  const PlaneDirection n = right_normal(e1);
  const PlaneDirection ahead = sign * d > 0 ? e1 : PlaneDirection{-e1.x, -e1.y};
  return {arc(at, n, ahead, d), arc(at, ahead, {-n.x, -n.y}, d)};
}

}  // namespace phrame
