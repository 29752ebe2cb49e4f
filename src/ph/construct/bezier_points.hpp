#pragma once
#include <vector>

#include "phrame/ph/curve/curve.hpp"

namespace phrame::inline v0 {

/// The control points of a Bézier curve, at least two, and not all equal.
using BezierPoints = std::vector<Vector<Rational>>;
/// Of a curve, in a degree that is not less than its own.
BezierPoints control_points_in_degree(const Curve& curve, std::size_t degree);
/// Of ∫ r′ from `start`, where r′ ≠ 0 has the degree n: n + 2 points.
BezierPoints bezier_points(const Vector<Polynomial>& hodograph, const Vector<Rational>& start);
/// The Bernstein coefficients of r′.
std::vector<Vector<Rational>> bezier_derivatives(const BezierPoints& points);

}  // namespace phrame
