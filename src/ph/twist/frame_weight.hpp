#pragma once
#include <vector>

#include "phrame/algebra/ball.hpp"
#include "phrame/export.hpp"
#include "phrame/ph/curve/curve.hpp"

namespace phrame::inline v0 {

/// The same curve with the real content of its preimage in the multiplier: σ has no real zero then,
/// and f has all cusps.
PHRAME_API Curve with_primitive_preimage(const Curve& curve);

/// What deviations along a curve are weighted by [Peng, Pang, Pan 2023, (13)].
enum class FrameWeight {
  one,                ///< 1
  torsion_curvature,  ///< |τκ|
  speed               ///< |r′|: the integral is one by the arc length then
};

/// Balls around ∫₀¹ ρ(t)·tᵏ dt for k = 0, …, count − 1 and a weight ρ of the curve, divided where
/// it has a kink. About so many bits are true. Throws DomainError where the weight is 0, |τκ| on
/// plane curves, or infinite, |τκ| at cusps.
PHRAME_API std::vector<RealBall> weight_moments(const Curve& curve, FrameWeight weight, long count,
                                                long bits);

}  // namespace phrame
