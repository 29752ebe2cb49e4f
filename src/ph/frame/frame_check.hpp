#pragma once
#include "phrame/export.hpp"
#include "phrame/ph/along/path_angle.hpp"
#include "phrame/ph/frame/frame_start.hpp"
#include "phrame/ph/frame/frame_verdict.hpp"

namespace phrame::inline v0 {

/// The frame that others are compared with, and the tolerance.
struct FrameCheckOptions {
  /// Where the rotation-minimizing frame starts that others are compared with; an angle is counted
  /// from e₂ of the reference frame. Without a start, that frame agrees with the first sample.
  std::optional<FrameStart> start = std::nullopt;
  Rational tolerance{1, 1'000'000};  ///< for angles, cosines and lengths
  /// v, where angles are measured from the frame of v, as by angle_to().
  std::optional<Vector<Rational>> up = std::nullopt;
};

/// Is the sine of the angle between each given tangent and ±T within the tolerance? Numbers are
/// exact, or off by less than 2^−192 of their size; this is much faster than check_frames().
PHRAME_API bool are_along_curve(const Path& path, const std::vector<GivenFrame>& frames,
                                const Rational& tolerance);

/// A point where somebody says that the curve is at t.
struct GivenPosition {
  Rational t;          ///< a parameter of the path
  Vector<Rational> r;  ///< the place
};

/// How far the positions are off the curve, but for one translation, which takes the first to its
/// place: over the way from the first to the farthest, squared. No value where all are one place.
/// Numbers are as those of are_along_curve().
PHRAME_API std::optional<Rational> squared_deviation(const Path& path,
                                                     const std::vector<GivenPosition>& positions);
/// Is that at most the square of the tolerance? Not where it has no value.
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
