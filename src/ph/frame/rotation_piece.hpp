#pragma once
#include <array>
#include <functional>

#include "phrame/algebra/piecewise_polynomial.hpp"

namespace phrame::inline v0 {

/// u, v, p, q of a quaternion as series in the y of a piece.
using QuaternionSeries = std::array<BallPolynomial, 4>;

/// How a unit quaternion B of t turns: σB′ = M·B, σ > 0, with a skew-symmetric
///
///       ⎛ 0  −a  −b  −c ⎞
///   M = ⎜ a   0  −c   b ⎟
///       ⎜ b   c   0  −d ⎟
///       ⎝ c  −b   d   0 ⎠
struct RotationEquation {
  Polynomial sigma, a, b, c, d;
};

inline constexpr long frame_bits = 128;  ///< of what is known of a piece

/// a, b, c, d of M by the y of a piece.
using RotationRates = std::array<BallPolynomial, 4>;

/// Around the coefficients of B up to y^{length−1}, up to the sign of B, from the piece, and σ and
/// M on it.
using RotationTaylor =
    std::function<QuaternionSeries(const PolynomialPiece& piece, const BallPolynomial& sigma,
                                   const RotationRates& M, long length)>;

/// B on [low, high] for a parameter t − origin, from its Taylor polynomials, proved afterwards: for
/// polynomials Q
///   |Q − B| ≤ |Q − B|(center) + ∫|σQ′ − M·Q|/min σ.
/// No value where [low, high] is to be divided.
std::optional<PolynomialPiece> rotation_piece(double low, double high, double origin,
                                              const RotationEquation& equation,
                                              const RotationTaylor& taylor,
                                              const DoubleShape& shape);

/// The piece with the polynomials nearest to the series, and its error: those that they are exactly
/// are off by remainder_of(them) at most, but for what they are off at the center. No value where
/// that is too much.
std::optional<PolynomialPiece> rounded_rotation_piece(
    PolynomialPiece piece, const QuaternionSeries& series,
    const std::function<RealBall(const QuaternionSeries& exact)>& remainder_of,
    const DoubleShape& shape);

}  // namespace phrame
