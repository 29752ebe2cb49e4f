#pragma once
#include "phrame/algebra/rational_function.hpp"
#include "phrame/export.hpp"
#include "phrame/ph/curve/curve.hpp"

namespace phrame::inline v0 {

/// The curve r′ = f · A i A*, r(0) = start, with a rational f. It is rational iff all residues of
/// the three components of r′ are 0, which is decided by Hermite's reduction. Throws DomainError
/// where one of them has a logarithm, "y has a logarithm: its residues at the roots of t^2 + 1 are
/// not 0", where f has a pole on [0, 1], and as Curve.
PHRAME_API Curve rational_ph_curve(const QuaternionPolynomial& preimage,
                                   const RationalFunction& multiplier,
                                   const Vector<Rational>& start = {});

/// A plane curve by its tangents n·r = p, the envelope of a family of lines.
struct TangentLines {
  Polynomial a;              ///< @{ n = (2ab, a² − b²)/(a² + b²), coprime
  Polynomial b;              ///< @}
  RationalFunction support;  ///< p
};
/// The curve in the plane z = 0 that these lines touch, r = p·n + (p′/φ′)·n⊥ for the angle φ of n:
/// a rational PH curve, and every rational curve with rational unit normals is one [Pottmann 1995].
/// Its offset by d to the side of n has the support p + d, and the same degree in general. Throws
/// DomainError where n does not turn, where a and b have a common factor, where a point of [0, 1]
/// is at infinity, and where all lines go through one point.
PHRAME_API Curve curve_of_tangents(const TangentLines& lines);
/// The tangent at t as homogeneous coordinates, K + L·x + M·y = 0:
/// (−(a² + b²)·n, 2ab·d, (a² − b²)·d) for p = n/d.
PHRAME_API Vector<Polynomial> line_coordinates(const TangentLines& lines);
/// The tangents of a plane PH curve in a plane z = const, as a family of lines; n is to the right
/// of A i A*. Throws DomainError for a curve in no such plane.
PHRAME_API TangentLines tangent_lines(const Curve& curve);

}  // namespace phrame
