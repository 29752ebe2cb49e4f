#pragma once
#include "phrame/ph/along/smooth_angle.hpp"
#include "phrame/ph/frame/compiled_angle.hpp"
#include "phrame/ph/frame/compiled_frame.hpp"

namespace phrame {

// Angles and frames of a path of any kind for millions of t in [0, end], proved and as fast as
// those of PH curves. Throw as compiled_angle().

/// θ + start, the square root in θ′ by a polynomial near it (angle_piece); shape.width = 1.
PiecewisePolynomial compiled_angle(const SmoothAngle& angle, const Real& start,
                                   const DoubleShape& shape);
/// The unit quaternion B whose (B i B*, B j B*, B k B*) is the rotation-minimizing frame at that
/// angle, up to its sign; shape.width = 4. The frame turns at e₁ × e₁′, about no part of e₁, so
/// that
///   σB′ = (H × H′)/2·B:
/// a linear equation without roots, by which each piece is proved (rotation_piece, of formulas
/// formula_piece). Precondition: the angle is to the frame of v.
PiecewisePolynomial compiled_rotation(const SmoothAngle& angle, const Real& start,
                                      const DoubleShape& shape);

/// @{ For evaluation. The frame's angle to that of v is θ + start.
CompiledAngle compile_angle(const SmoothAngle& angle, const Real& start = Rational(0));
CompiledFrames compile_frames(const SmoothAngle& angle, const Real& start = Rational(0));
/// @}

}  // namespace phrame
