#pragma once
#include <array>
#include <optional>
#include <string>

#include "phrame/io/read/number_table.hpp"

namespace phrame::inline v0 {

/// Where a table of poses without names has its numbers.
struct PoseColumns {
  std::array<std::size_t, 3> position;
  /// The matrix of the rotation, row by row: its columns are the axes of the body in the world.
  std::array<std::size_t, 9> rotation;
  std::string what;  ///< "rows of a 3 × 4 matrix", for notes
};

/// Of tables of 12 columns, 3 × 4 matrices (R | r) row by row, as the KITTI odometry benchmark
/// writes them; and of 16, 4 × 4 matrices row by row, whose last row is 0, 0, 0, 1, or column by
/// column, as WebGL has them. No value where in any row R is not a rotation to within 1/100 or the
/// last row is another; rows that miss a number do not count.
std::optional<PoseColumns> matrix_columns(const NumberTable& table);

/// Are these four columns a quaternion of length 1, to within 1/100, in every row that misses no
/// number?
bool is_unit_quaternion(const NumberTable& table, std::size_t first_column);

}  // namespace phrame
