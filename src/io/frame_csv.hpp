#pragma once
#include <string_view>

#include "phrame/ph/frame_check.hpp"

namespace phrame {

/// How a quaternion q means a frame: q turns the axes x, y, z of the body to the world, v ↦ q v q*.
struct QuaternionConvention {
  std::size_t tangent_axis = 0;  ///< which of x, y, z is the tangent; f₂ and f₃ are the next two
  bool is_inverse = false;       ///< q turns the world to the body
};

/// Reads a table of frames: lines of numbers, separated by commas, below a header that names the
/// columns t and f2x, f2y, f2z, optionally f3x, … and e1x, … (the tangent); or t and qw, qx, qy,
/// qz, which are all three vectors. Other columns are skipped, as are empty lines and lines that
/// begin with '#'. Numbers are read exactly. Throws InputError; its place is "line 3" or "line 3,
/// f2x".
std::vector<GivenFrame> read_frames(std::string_view text,
                                    const QuaternionConvention& convention = {});

}  // namespace phrame
