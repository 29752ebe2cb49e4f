#pragma once
#include "phrame/answer/interpolation.hpp"
#include "phrame/export.hpp"
#include "phrame/ph/curve/frame_through.hpp"
#include "phrame/ph/frame/frame_start.hpp"

namespace phrame::inline v0 {

/// The vector of a frame that a tool is along, from its tip to the spindle.
enum class ToolAxis { e1, f2, f3 };

/// Asks how a machine with two rotary axes follows a motion. Times are in seconds.
struct MachineQuery {
  InterpolationQuery motion;     ///< its points
  ToolAxis tool = ToolAxis::f3;  ///< along which vector it is
  FrameStart start = {};         ///< of the rotation-minimizing frame
  /// Orientations that the frame is to have instead, as PathTwist has them.
  std::optional<FrameThrough> through = {};
  std::optional<Vector<Rational>> up = {};  ///< v, as angle_to() has it
  long places = 4;                          ///< decimals, ≥ 0
};

/// Where a machine is to be, in units of 10^−places.
struct MachineMove {
  std::array<Integer, 3> tip;  ///< X, Y, Z, the point of the path
  /// @{ A and C, in degrees: the tool is along (sin C sin A, −cos C sin A, cos A).
  Integer a, c;
  /// @}
  Integer feed;  ///< 1/minutes that the move to there takes; 0 for the start
  /// A is a multiple of 180°, where any C is right: C of the move before is kept.
  bool is_pole = false;
};

/// The moves of a machine, all numbers correctly rounded.
struct MachinePath {
  ToolAxis tool;                       ///< that of the query
  FrameStart start;                    ///< likewise
  std::optional<Vector<Rational>> up;  ///< v, where the angle at the start is to its frame
  long places;                         ///< of the numbers: decimals
  std::vector<MachineMove> moves;      ///< the first is where it starts
};

/// Of the two pairs (A, C), (−A, C + 180°) and their whole turns each move takes the pair nearest
/// to the one before, so that angles go on and on; the first has A ≥ 0 and −180° < C ≤ 180°. Poles
/// are where A is a multiple of 180° once it is rounded. Throws as the interpolation does, as
/// start_angle() and PathTwist, and InputError at "places" where a feed rounds to 0.
PHRAME_API MachinePath answer(const NamedPath& named, const MachineQuery& query);

}  // namespace phrame
