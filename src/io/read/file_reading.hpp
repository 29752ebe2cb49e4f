#pragma once
#include <string>
#include <string_view>

#include "phrame/export.hpp"

namespace phrame {

/// What is asked of whoever reads a file, beside the limits.
struct PHRAME_API FileReading {
  /// Of tables and lists of points: rows that miss a number, and points that are those before them,
  /// are left out, and a note says how many. Otherwise the first of them is refused.
  bool skips_invalid = false;
  /// Of a file with several curves, the one of this name; where it is empty, a file with several is
  /// refused with the list of their names.
  std::string pick = {};
  /// Of tables and lists of points what they are: natural, periodic, polyline, bezier or bspline.
  std::string kind = {};
  /// A column that is read for something else, so that it is not said to be skipped.
  std::string other_column = {};
  bool skips_where_possible = false;  ///< files without such rows are not refused then

  /// Is nothing asked?
  bool is_plain() const { return !skips_invalid && pick.empty() && kind.empty(); }
  /// Throws InputError, its place the option of the program, for what means nothing in a file that
  /// is this, "an SVG file", whose points or curves it is not about.
  void refuse_skipping(std::string_view what) const;
  void refuse_picking(std::string_view what) const;
};

}  // namespace phrame
