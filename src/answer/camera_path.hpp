#pragma once
#include <array>

#include "phrame/answer/frame_table.hpp"
#include "phrame/export.hpp"

namespace phrame {

/// Where a camera is and how it is turned at some times: it looks along its −z axis, which is e₁;
/// its y axis, up in the picture, is the first vector f₂ of the frame, and x, to the right, f₃.
struct CameraPath {
  std::vector<double> times;                     ///< in seconds from 0, ascending
  std::vector<Vector<double>> places;            ///< r
  std::vector<std::array<double, 4>> rotations;  ///< unit quaternions (x, y, z, w), as of a table
  Vector<double> origin = {};                    ///< near the places: floats hold r from there well
};

/// What the table of a camera path is asked for: this frame, with a camera's quaternions.
PHRAME_API TableColumns camera_columns(TabulatedFrame frame);

/// The camera path of a table with such columns, with the numbers of its rows for times, less the
/// first; with a `duration` > 0, times are those in proportion that end there. Throws InputError
/// without a place for fewer than two rows, for numbers that do not ascend in the precision of
/// floats, which most programs have for times, and for places that no float is near to.
PHRAME_API CameraPath camera_path(const FrameTable& table, const std::vector<Rational>& numbers,
                                  const std::optional<Rational>& duration);

}  // namespace phrame
