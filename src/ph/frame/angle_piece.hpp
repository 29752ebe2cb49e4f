#pragma once
#include <functional>

#include "phrame/algebra/piecewise_polynomial.hpp"
#include "phrame/integrate/taylor_integral.hpp"

namespace phrame::inline v0 {

inline constexpr long angle_bits = 128;  ///< of what is known of a piece

/// θ on [low, high], θ′(t) = N/(D√S) of t − origin there, from balls around θ(center): Taylor
/// polynomials p, proved afterwards. With a polynomial w near 1/√S
///   |p − θ| ≤ |p − θ|(center) + ∫(|p′·D − N·w| + |N|·|w − 1/√S|)/min D,
///   |w − 1/√S| ≤ (|w√S − 1|(center) + ∫|S·w′ + S′·w/2|/min √S)/min √S.
/// No value where [low, high] is to be divided. Throws Undecided where a constant angle is not told
/// from 0.
std::optional<PolynomialPiece> angle_piece(
    double low, double high, double origin, const RootQuotient& rate,
    const std::function<RealBall(double center, long bits)>& theta, const DoubleShape& shape);

/// The piece with the polynomial nearest to θ(center) + from_center, and its error: for a
/// polynomial p, |p − p(0) − (θ − θ(center))| is at most remainder_of(p). No value where that is
/// too much. Throws likewise.
std::optional<PolynomialPiece> rounded_angle_piece(
    PolynomialPiece piece, const BallPolynomial& from_center,
    const std::function<RealBall(const BallPolynomial& p)>& remainder_of,
    const std::function<RealBall(double center, long bits)>& theta, const DoubleShape& shape);

}  // namespace phrame
