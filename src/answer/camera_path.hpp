#pragma once
#include <array>

#include "phrame/answer/frame_table.hpp"
#include "phrame/export.hpp"

namespace phrame::inline v0 {

/// The places and rotations of a camera at some times. It looks along its −z axis, which is e₁; its
/// y axis, up in the picture, is the first vector f₂ of the frame, and its x axis, to the right, is
/// f₃.
struct CameraPath {
  std::vector<double> times;                     ///< in seconds from 0, ascending
  std::vector<Vector<double>> places;            ///< r
  std::vector<std::array<double, 4>> rotations;  ///< unit quaternions (x, y, z, w), as of a table
  /// @{ Where the frame starts, and v where an angle there is to the frame of v; of a
  /// rotation-minimizing frame only.
  std::optional<FrameStart> start = {};
  std::optional<Vector<Rational>> up = {};
  /// @}
  Vector<double> origin = {};  ///< near the places, so that floats hold r − origin well
};

/// The columns of the table that a camera path is made of: this frame, with quaternions of a
/// camera.
PHRAME_API TableColumns camera_columns(TabulatedFrame frame);

/// Makes the camera path of a table with those columns. `numbers` belong to the rows; the times are
/// these numbers less the first of them, scaled to end at `duration` where there is one, which is >
/// 0. Throws InputError without a place for fewer than two rows, for numbers that do not ascend as
/// floats, which most programs have for times, and for places that no float is near to.
PHRAME_API CameraPath camera_path(const FrameTable& table, const std::vector<Rational>& numbers,
                                  const std::optional<Rational>& duration);

}  // namespace phrame
