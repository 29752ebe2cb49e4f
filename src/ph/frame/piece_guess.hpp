#pragma once
#include "phrame/ph/frame/rotation_piece.hpp"

namespace phrame::inline v0 {

// Half of the pieces that are tried are too long, and to prove one is dear. So the Taylor series is
// made in doubles first: the proof finds at least the coefficient of y^{degree+1}, which the
// polynomials lack. That is a guess only: a piece that is taken is proved in any case, and one that
// is divided in vain costs time.

/// Whether f, where f′ = N/(D√S), is not within goal·(variation + 1) of a polynomial of the degree
/// of the shape.
bool seems_too_long(const BallPolynomial& N, const BallPolynomial& D, const BallPolynomial& S,
                    const DoubleShape& shape);

/// The same of B, where σB′ = M·B and |B| = 1.
bool seems_too_long(const BallPolynomial& sigma, const RotationRates& M, const DoubleShape& shape);

}  // namespace phrame
