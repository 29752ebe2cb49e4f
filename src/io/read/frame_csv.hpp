#pragma once
#include <string>
#include <string_view>

#include "phrame/export.hpp"
#include "phrame/ph/frame/frame_check.hpp"

namespace phrame::inline v0 {

/// How the numbers of a table mean frames, as far as the table does not say so itself. A quaternion
/// q turns the axes x, y, z of the body to the world, v ↦ q v q*, and so does a matrix, whose
/// columns they are.
struct FrameReading {
  /// The four columns from left to right; `named`: by their names, else w, x, y, z.
  enum class Quaternion { named, wxyz, xyzw };
  Quaternion quaternion = Quaternion::named;  ///< how its columns are ordered
  /// Which of x, y, z is the tangent; f₂ and f₃ are the next two.
  std::size_t tangent_axis = 0;
  /// The tangent is the opposite of that axis, and f₂ and f₃ change places.
  bool is_axis_reversed = false;
  bool is_inverse = false;  ///< q turns the world to the body
  /// The names of the columns of a table without a header. If empty, their number tells.
  std::vector<std::string> names = {};
  bool skips_invalid = false;  ///< rows that miss a number are left out
  /// The parameters of the rows, for those of the table; empty where these are right.
  std::vector<Rational> parameters = {};

  friend bool operator==(const FrameReading&, const FrameReading&) = default;
};

/// What read_frames() has read.
struct GivenTable {
  std::vector<GivenFrame> frames;    ///< a row each
  std::vector<std::string> columns;  ///< t, x, y, … where their number told what they are
  std::size_t skipped = 0;           ///< further columns there
  bool has_quaternions = false;      ///< are the frames given by quaternions?
  bool has_matrices = false;         ///< or by matrices?
  /// Has it a column t? Else it has positions, which tell where on the curve a frame is.
  bool has_parameters = true;
  /// Of the frames, where the table has them, at their parameters, times or numbers.
  std::vector<GivenPosition> positions = {};
  std::vector<std::string> notes = {};  ///< what was assumed, in sentences without a point
};

/// Reads a table of frames: a .npy file (NpyTable) or text. The text is lines of numbers, separated
/// by ';', ',', tabs or blanks, whichever of them comes first in this list and in the first line; a
/// header above names the columns t and f2x, f2y, f2z, optionally f3x, … and e1x, … (the tangent);
/// or t and qw, qx, qy, qz, which are all three vectors. Other columns are skipped, as are empty
/// lines and lines that begin with '#', but the last of these above the numbers is the header where
/// there is no other and it has as many words. A column may be there twice if it is the same. A
/// table without a header is t, followed by f2 (4 columns in all), a quaternion (5), f2 and f3 (7),
/// position and quaternion (8), e1, f2 and f3 (10), position, e1, f2 and f3 (13 or more, the rest
/// is skipped); 12 and 16 columns may be matrices (matrix_columns). A table with positions, x, y, z
/// or under other names (position_column), may have a column time, timestamp or none for t.
/// Numbers are read exactly. Of more than `at_most` ≥ 2 rows so many are read, from the first to
/// the last at about equal distances. Throws InputError; its place is "line 3" or "line 3, f2x", in
/// a .npy file "header", "data", "row 3" or "row 3, f2x".
PHRAME_API GivenTable read_frames(std::string_view bytes, const FrameReading& reading = {},
                                  std::size_t at_most = std::string_view::npos);

/// The columns x, y, z of a table that `reading` names, of numbers all of them.
/// Precondition: these names are among the reading's, and the table has no others.
PHRAME_API std::vector<GivenPosition> read_positions(std::string_view bytes,
                                                     const FrameReading& reading);

/// Other ways to read a table whose convention is not certain, those near `reading` first.
PHRAME_API std::vector<FrameReading> other_readings(const GivenTable& table,
                                                    const FrameReading& reading);

/// As options of `phrame check`: "--quaternion xyzw --tangent-axis z".
PHRAME_API std::string to_options(const FrameReading& reading);

}  // namespace phrame
