#pragma once
#include "phrame/answer/angle.hpp"
#include "phrame/answer/check.hpp"
#include "phrame/answer/classification.hpp"
#include "phrame/answer/compiled.hpp"
#include "phrame/answer/frame_table.hpp"
#include "phrame/answer/info.hpp"
#include "phrame/answer/page_rows.hpp"
#include "phrame/answer/totals.hpp"
#include "phrame/ph/proof/certificate.hpp"

namespace phrame::inline v0 {

/// Asks for all that a page shows of a path: its frames, its angle, its numbers, and frames that
/// somebody else has computed for it.
struct PageQuery {
  /// The least number of rows, ≥ 2, equally many on each segment. Rows are added where the plotted
  /// graphs have a maximum or minimum and where they bend much.
  long samples = 241;
  /// θ(0), or where f₂ is at t = 0. By default f₂ starts where the first given frame has it, if
  /// that is at t = 0; else θ(0) = 0.
  std::optional<FrameStart> start = {};
  /// v, where θ is measured from the frame of v, as by angle_to().
  std::optional<Vector<Rational>> up = {};
  /// f₂ at the end of the frame of minimal twist of an open path, before it is projected to the
  /// normal plane. Without it the page of an open path has no such frame.
  std::optional<Vector<Rational>> end_normal = {};
  std::vector<GivenFrame> given = {};  ///< frames of somebody else; there is a row at the t of each
};

/// All that a page about a path shows.
struct PageAnswer {
  AngleAnswer angle;  ///< the angle, with its formula where the path is a PH curve
  InfoAnswer info;    ///< its polynomials and totals
  /// Its totals; left out of paths with many segments, where they take long.
  std::optional<TotalsAnswer> totals = {};
  std::optional<ClassificationAnswer> classification{};  ///< of a PH path that is not too long
  std::vector<TabulatedFrame> frames;  ///< in the table: those that are defined somewhere
  /// The columns t, r, e₁, the frames, s, curvature, torsion and theta; of a PH path theta_rate =
  /// dθ/dt and speed = |dr/dt|, too. Where there are given frames, their f₂ and f₃ are the columns
  /// g2 and g3, and error is the angle of g2 to the exact frame, the middle of the ball that the
  /// check finds. Numbers that are undefined, and those of given frames in rows without one, are
  /// NaN.
  FrameTable table;
  std::optional<CheckAnswer> check = {};  ///< of the given frames
  std::optional<Certificate> certificate =
      {};  ///< of θ at the end, from 0, of a PH curve of no high degree
  std::optional<CompiledAnswer> compiled = {};  ///< of paths of few segments
  bool is_closed = false;                       ///< its end is its start, with the same tangent
  std::vector<PageJump> jumps = {};             ///< the joints where a number of the table jumps
  PathTurns turns = {};                         ///< maxima and minima among the rows
};

/// The frames are rmf, erf or up, frenet, and exact_mtf: along a closed path the frame that comes
/// back to its start with the least turn, along an open one the frame that ends with the end
/// normal. Throws as frame_table() and the other answers, and DomainError for an end normal that is
/// along the tangent or of a closed path.
PageAnswer answer(const NamedPath& named, const PageQuery& query);

}  // namespace phrame
