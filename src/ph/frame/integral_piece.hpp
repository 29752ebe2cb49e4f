#pragma once
#include <functional>
#include <variant>

#include "phrame/ph/curve/curve_integrands.hpp"
#include "phrame/ph/curve/segment.hpp"
#include "phrame/ph/frame/angle_piece.hpp"

namespace phrame::inline v0 {

/// What is integrated along a segment that is compiled: N/(D√S) of a rational curve, a function of
/// formulas.
using PieceRate = std::variant<RootQuotient, CurveIntegrand>;

/// The integral of the rate on [low, high] of segment k of a path, [k, k + 1], from balls around it
/// at the center: angle_piece, of formulas formula_angle_piece.
std::optional<PolynomialPiece> integral_piece(
    std::size_t k, const Segment& segment, const PieceRate& rate, double low, double high,
    const std::function<RealBall(double center, long bits)>& integral, const DoubleShape& shape);

/// The piece, where its error, with the rounding errors of what is not summed with compensation, is
/// small beside what it varies by: then nearly all values round. No value where it is to be
/// divided.
std::optional<PolynomialPiece> well_rounded(std::optional<PolynomialPiece> piece,
                                            const DoubleShape& shape);

}  // namespace phrame
