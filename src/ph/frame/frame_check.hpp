#pragma once
#include "phrame/export.hpp"
#include "phrame/ph/along/path_angle.hpp"
#include "phrame/ph/frame/frame_start.hpp"
#include "phrame/ph/frame/frame_verdict.hpp"

namespace phrame {

/// What frames are compared with, and how exactly.
struct FrameCheckOptions {
  /// Where the rotation-minimizing frame that the frames are compared with starts; an angle is that
  /// to e₂ of the frame that angles are measured from. Without it, that frame agrees with the first
  /// sample.
  std::optional<FrameStart> start = std::nullopt;
  Rational tolerance{1, 1'000'000};  ///< for angles, cosines and lengths
  /// v, where angles are to be measured from its frame, as angle_to() has it.
  std::optional<Vector<Rational>> up = std::nullopt;
};

/// Is the sine of the angle between each tangent given and ±T within the tolerance? By numbers that
/// are exact or off by less than 2^−192 of their size, and much faster than check_frames().
PHRAME_API bool are_along_curve(const Path& path, const std::vector<GivenFrame>& frames,
                                const Rational& tolerance);

/// Where somebody says that the curve is at t.
struct GivenPosition {
  Rational t;          ///< a parameter of the path
  Vector<Rational> r;  ///< the place
};

/// Are these positions the curve's but for one translation, which takes the first to its place? To
/// within the tolerance times the way from the first to the farthest; where all are one place, they
/// are no sign of the curve. By numbers as those of are_along_curve().
PHRAME_API bool are_on_curve(const Path& path, const std::vector<GivenPosition>& positions,
                             const Rational& tolerance);

/// Judges frames, with the exact ones of the path: they pass where all angles, cosines and lengths
/// are within the tolerance and no frame is left-handed. First and last are those of the least and
/// the largest t; at a corner a frame is compared with that of the side whose tangent it fits
/// better. Where f or p changes its sign, the tangent is either vector: the one that most of the
/// frames take for forward. Throws Undecided where 4096 bits do not tell a number from the
/// tolerance, and DomainError as start_angle() does, and for a t outside the path. Preconditions:
/// there is at least one frame, and the angle is not to the Frenet frame.
PHRAME_API FrameVerdict check_frames(const PathAngle& angle, const std::vector<GivenFrame>& frames,
                                     const FrameCheckOptions& options = {});

}  // namespace phrame
