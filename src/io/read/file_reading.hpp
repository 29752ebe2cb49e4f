#pragma once
#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include "phrame/export.hpp"

namespace phrame::inline v0 {

/// How a file is to be read, beside the limits.
struct PHRAME_API FileReading {
  /// In tables and lists of points, leave out rows that miss a number and points that are equal to
  /// those before them; a note says how many. Otherwise the first of them is refused.
  bool skips_invalid = false;
  /// The name of the curve that is read of a file with several. Where it is empty, a file with
  /// several is refused, with the list of their names.
  std::string pick = {};
  /// What the points of tables and lists are: natural, periodic, polyline, bezier or bspline.
  std::string kind = {};
  /// The names of columns that are read for something else: no note says that they were skipped.
  std::vector<std::string> other_columns = {};
  /// Are points x, y, r, with a radius as the third coordinate? Tables may call it so.
  bool has_radii = false;
  /// What is in the file of this name beside the one that is read, as of buffers in glTF. Without
  /// it other files are not read.
  std::function<std::string(const std::string& name)> beside = {};
  /// With skips_invalid: files that have no rows to skip are not refused.
  bool skips_where_possible = false;

  /// Has nothing of this been asked for?
  bool is_plain() const { return !skips_invalid && pick.empty() && kind.empty(); }
  /// @{ Throws InputError, its place the option of the program, where rows are to be skipped, or a
  /// curve is to be picked, in a file that has none: `what`, "an SVG file".
  void refuse_skipping(std::string_view what) const;
  void refuse_picking(std::string_view what) const;
  /// @}
};

/// FileReading::beside of a file with this path: reads those in its folder. Throws InputError, its
/// place their name, where one cannot be read.
PHRAME_API std::function<std::string(const std::string& name)> files_beside(
    const std::string& path);

}  // namespace phrame
