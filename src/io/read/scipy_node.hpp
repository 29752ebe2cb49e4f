#pragma once
#include "phrame/io/read/curve_file.hpp"
#include "phrame/io/read/json_node.hpp"
#include "phrame/io/read/point_curve.hpp"

namespace phrame::inline v0 {

/// Is it a curve of scipy.interpolate, as people write it to JSON: an object with t, c and k (a
/// BSpline) or with c and x (a PPoly, as CubicSpline is); the list [t, c, k] of splprep, or [[t, c,
/// k], u]?
bool is_scipy_curve(const JsonNode& node);
/// The curve, of two or three dimensions. Coefficients c of a BSpline are a point each, (n, d), or
/// a list for each coordinate, (d, n), as splprep has them; those behind the first len(t) − k − 1
/// do not count. Of a PPoly c[i][j] is the coefficient of (x − x[j])^(k − i) on [x[j], x[j + 1]].
/// In doubles the pieces of cubic ones do not quite meet: then the curve is the C¹ cubic with their
/// values and derivatives at the breakpoints, from the right, at the last from the left, if they
/// are apart by less than 10^−9 of their size, and a note says by how much. Throws InputError.
PointCurve read_scipy(const JsonNode& node, const CurveLimits& limits);

}  // namespace phrame
