#pragma once
#include <functional>

#include "phrame/algebra/piecewise_polynomial.hpp"
#include "phrame/ph/along/expression_integral.hpp"

namespace phrame::inline v0 {

// Pieces of what is compiled along a curve by formulas: Taylor polynomials, with Cauchy's bounds on
// the disc of eight times the size of the piece, |z| ≤ 4, for what they leave out. t is counted
// from the joint `origin`. No value where [low, high] is to be divided.

/// θ with θ′ = y, from balls around θ(center).
std::optional<PolynomialPiece> formula_angle_piece(
    double low, double high, double origin, const ExpressionCurve& curve, const CurveIntegrand& y,
    const std::function<RealBall(double center, long bits)>& theta, const DoubleShape& shape);

/// The component number k of r, from balls around it at the center.
std::optional<PolynomialPiece> formula_point_piece(
    double low, double high, double origin, const ExpressionCurve& curve, std::size_t k,
    const std::function<RealBall(double center, long bits)>& at_center, const DoubleShape& shape);

/// The unit quaternion B of a frame that does not turn about the tangent,
///   B′ = (r′ × r″)/(2|r′|²)·B,  |B(z)| ≤ exp(4K) where |r′ × r″|/(2|r′|²) ≤ K on |z| ≤ 4,
/// from balls around B(center).
std::optional<PolynomialPiece> formula_rotation_piece(
    double low, double high, double origin, const ExpressionCurve& curve,
    const std::function<std::array<RealBall, 4>(double center, long bits)>& at_center,
    const DoubleShape& shape);

}  // namespace phrame
