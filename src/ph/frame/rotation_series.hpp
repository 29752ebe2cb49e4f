#pragma once
#include "phrame/ph/curve/vector.hpp"
#include "phrame/ph/frame/rotation_piece.hpp"

namespace phrame::inline v0 {

/// The solution B of σB′ = w·B, a product of quaternions with the vector w, from B at 0, by the
/// recurrence
///   (n + 1)·σ₀·Bₙ₊₁ = Σ wⱼ·Bₙ₋ⱼ − Σ (n + 1 − i)·σᵢ·Bₙ₊₁₋ᵢ,  i ≥ 1.
QuaternionSeries rotation_series(const std::array<RealBall, 4>& at_zero,
                                 const Vector<BallPolynomial>& w, const BallPolynomial& sigma,
                                 long length, long bits);

}  // namespace phrame
