#pragma once
#include "phrame/ph/frame/frame_verdict.hpp"

namespace phrame::inline v0 {

/// How far frames were off that somebody computed with this step.
struct StepError {
  std::size_t samples;  ///< the number of frames
  Rational step;        ///< the greatest from one t to the next
  RealBall error;       ///< the largest, in radians
  /// That they took to compute, as told; no value where it is not.
  std::optional<Rational> seconds = std::nullopt;
};

/// Errors below are those of doubles, not of a method.
inline const Rational rounding_level{1, 1'000'000'000'000};

/// At which rate errors fall with the step. The error of a method of order p is about c·stepᵖ.
struct Convergence {
  std::vector<StepError> steps;  ///< from the greatest step to the least
  /// p for each pair of neighbours, so that error₁/error₂ = (step₁/step₂)ᵖ, by their balls; no
  /// value where an error is at the rounding_level.
  std::vector<std::optional<RealBall>> rates;
  /// The rate of the finest pair that has one: where the steps are small enough, the order.
  std::optional<RealBall> order;
};

/// Of the frames with this verdict.
StepError step_error(const std::vector<GivenFrame>& frames, const FrameVerdict& verdict);
/// Of several; of those with the same step the last one counts.
Convergence convergence(std::vector<StepError> steps);

}  // namespace phrame
