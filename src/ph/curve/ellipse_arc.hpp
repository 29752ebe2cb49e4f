#pragma once
#include <array>

#include "phrame/algebra/ball.hpp"
#include "phrame/ph/curve/rational_bezier.hpp"

namespace phrame::inline v0 {

// Arcs of ellipses in the plane z = 0 as rational Bézier curves of degree 2, over ℚ. An ellipse is
// the image of the unit circle; of that, an arc between rational points is rational. Where a point
// is not, as most that are given by angles or radii, the nearest rational one with a short
// parameter is taken: each function says which of its data are kept exactly.

/// Numbers that are rounded are rounded to so many bits.
inline constexpr long ellipse_bits = 100;

/// √x, x > 0: exactly where it is a fraction, else to ellipse_bits bits.
Rational near_root(const Rational& x);
/// A point or vector of the plane.
using PlaneVector = std::array<Rational, 2>;
Rational plane_dot(const PlaneVector& a, const PlaneVector& b);  ///< a·b
Rational plane_cross(const PlaneVector& a,
                     const PlaneVector& b);  ///< > 0 where b is to the left of a
/// The point of the unit circle in the direction of v ≠ 0: exactly where that is a fraction, else
/// near it.
PlaneVector near_direction(const PlaneVector& v);
/// (c, s) with c² + s² = 1, near cos φ and sin φ: exactly for multiples of a right angle, else
/// tan(φ/2), of the angle reduced to (−π/2, π/2], is a multiple of 2^−ellipse_bits.
PlaneVector rotation_by_degrees(const Rational& degrees);
/// The same of an angle in radians. An angle within 2^−48 of k·π/2, relatively, as doubles are that
/// mean it, is taken for it.
PlaneVector rotation_by_radians(const Rational& angle);

/// The ellipse center + x·a + y·b, x² + y² = 1.
struct Ellipse {
  PlaneVector center;
  PlaneVector a;
  PlaneVector b;
};
/// The arc from the point of (x, y) = `from` to that of `to`, both on the unit circle, with the
/// angle growing, or falling; the whole ellipse where both are equal. Exact. Quarters of the
/// circle, and what is left over.
std::vector<RationalBezier> ellipse_arc(const Ellipse& ellipse, const PlaneVector& from,
                                        const PlaneVector& to, bool is_growing);

/// The arc between two points of an ellipse with these semiaxes, the first of which is turned from
/// x by an angle: of the four of SVG the one that is more than half or not, with the angle growing
/// or falling [SVG 2, 9.5]. Both points are kept exactly. The semiaxes are changed by less than
/// 2^−ellipse_bits of themselves where that makes the center rational; they are made large enough
/// where they are too small, as there. Neither is 0, and the points are different.
struct EndpointArc {
  PlaneVector from;
  PlaneVector to;
  std::array<Rational, 2> semiaxes;  ///< of any sign
  PlaneVector axis;                  ///< the direction of the first, of length 1
  bool is_large;
  bool is_growing;
};
std::vector<RationalBezier> ellipse_arc(const EndpointArc& arc);

}  // namespace phrame
