#pragma once
#include <string_view>

#include "phrame/io/read/file_reading.hpp"
#include "phrame/io/read/frame_csv.hpp"
#include "phrame/ph/construct/given_points.hpp"

namespace phrame::inline v0 {

/// How the numbers of poses mean orientations, as far as a file does not say so itself.
struct PoseReading {
  /// None: as its columns are named, without names x, y, z, w; in poses/1 as that says.
  std::optional<FrameReading::Quaternion> quaternion = {};
  std::optional<TangentAxis> tangent = {};  ///< none: as poses/1 says, else x
  bool is_inverse = false;                  ///< do they turn the world to the body?
  std::vector<long> turns = {};             ///< GivenPoses::turns, instead of those of the file
  bool is_smooth = false;                   ///< GivenPoses::is_smooth, beside that of the file
};

/// Is it JSON of the format poses/1?
bool is_pose_file(std::string_view bytes);

/// Reads points with orientations. In poses/1 (docs/poses.md), JSON, are `points`, and as many
/// `orientations`: four numbers are a quaternion, of `order` "xyzw", if it does not say "wxyz";
/// three lists of three the rows of a matrix; an object has two or all of the axes `e1`, `e2`, `e3`
/// of the body. Further `tangent_axis`, `parameters`, `turns` and `twist`, "even" or "smooth". Or a
/// table that has points (read_points) and frames (read_frames): quaternions, matrices, or two of
/// the vectors e1, f2, f3, which are the axes x, y, z of the body then; its tangents and
/// derivatives do not count. Throws InputError as these, and for what is no rotation
/// (nearest_rotation()).
GivenPoints read_poses(std::string_view bytes, const PoseReading& poses,
                       const FileReading& reading = {});

}  // namespace phrame
