#pragma once
#include "phrame/ph/along/smooth_angle.hpp"
#include "phrame/ph/frame/frame_check.hpp"

namespace phrame {

/// Judges frames of a path of any kind, as check_frames() does those of a PH path; the reference
/// frame is that of the angle's v. Throws Undecided where 4096 bits do not tell a number from the
/// tolerance, and DomainError as start_angle() does, and for a t outside [0, end()].
/// Preconditions: there is at least one frame, and the angle is to the frame of v.
FrameVerdict check_frames(const SmoothAngle& angle, const std::vector<GivenFrame>& frames,
                          const FrameCheckOptions& options = {});

/// @{ The same as of PH paths, by numbers that are exact or off by less than 2^−192 of their size.
bool are_along_curve(const Path& path, const std::vector<GivenFrame>& frames,
                     const Rational& tolerance);
bool are_on_curve(const Path& path, const std::vector<GivenPosition>& positions,
                  const Rational& tolerance);
/// @}

}  // namespace phrame
