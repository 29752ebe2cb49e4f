#pragma once
#include <functional>

#include "phrame/answer/frame_table.hpp"
#include "phrame/ph/along/turns.hpp"

namespace phrame::inline v0 {

/// The maxima and minima of the graphs along a path.
struct PathTurns {
  std::vector<PathParameter> at;  ///< in no order; of long paths where each goes farthest
  std::vector<Plotted> infinite;  ///< the quantities with a pole on the path
  bool are_all = true;            ///< as Turns::are_all, for all segments
  double slack = 0;               ///< likewise
};

/// Of all segments: of κ and τ, and where the angle is to the Euler–Rodrigues frame, so that there
/// are closed forms, of θ, θ′ and |r′|, too.
PathTurns path_turns(const PathAngle& angle);

/// A joint where a number of the table jumps: its limit from the left is another than that from the
/// right.
struct PageJump {
  std::size_t row;             ///< of the table, at the joint
  std::vector<double> before;  ///< the row with the limits from the left
};

/// The rows of a page, ascending.
struct PageRows {
  std::vector<PathParameter> at;  ///< where they are
  FrameTable table;               ///< a row for each
  std::vector<PageJump> jumps;    ///< ascending
};

/// Makes a row at each of these places.
using RowMaker = std::function<FrameTable(const std::vector<PathParameter>&)>;

/// Rows at these places, which are to hold the first and the last of the path, and between them
/// where straight lines between neighbours are seen not to be the graph.
PageRows page_rows(std::vector<PathParameter> at, const RowMaker& make);

/// Are they the same place, as far as a double tells? An end of a segment is not the start of the
/// next.
bool is_same_place(const PathParameter& a, const PathParameter& b);
bool is_before(const PathParameter& a, const PathParameter& b);  ///< in the order along the path

}  // namespace phrame
