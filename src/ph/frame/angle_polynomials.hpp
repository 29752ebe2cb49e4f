#pragma once
#include "phrame/algebra/piecewise_polynomial.hpp"
#include "phrame/ph/along/path_angle.hpp"

namespace phrame::inline v0 {

/// θ + start_angle on [from, to] as Taylor polynomials; shape.width = 1. Each is proved afterwards,
/// whatever it was found by: with θ′ = n/d and a polynomial p, all of p′·d − n is known, so that on
/// the piece
///   |p − θ| ≤ |p(center) − θ(center)| + ∫|p′·d − n|/min d.
/// Throws as PiecewisePolynomial does: Undecided where a pole of θ′ is nearer to [from, to] than
/// doubles are to each other there. Cost: some 10 to 1000 values of θ, more near a near-cusp.
PiecewisePolynomial compiled_angle(const RmfAngle& angle, const FrameAngle& start_angle,
                                   double from, double to, const DoubleShape& shape);

/// The same along a path, on [0, end]; where θ′ has a square root, by a polynomial near it
/// (angle_piece), of formulas formula_piece.
PiecewisePolynomial compiled_angle(const PathAngle& angle, const StartAngle& start_angle,
                                   const DoubleShape& shape);
/// The same of its segment k, on [k, k + 1].
PiecewisePolynomial compiled_angle(const PathAngle& angle, std::size_t segment,
                                   const StartAngle& start_angle, const DoubleShape& shape);

}  // namespace phrame
