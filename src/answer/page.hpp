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

namespace phrame {

/// What is there to see of a path: its frames, its angle and what is known of it, and frames that
/// somebody else has of it?
struct PageQuery {
  /// At least so many rows, ≥ 2, equally many on each segment. There are others where the graphs of
  /// what is plotted turn round, and where they bend much.
  long samples = 241;
  /// θ(0), or where f₂ is at t = 0; by default where the first given frame has it, if that is at t
  /// = 0, else θ(0) = 0.
  std::optional<FrameStart> start = {};
  std::optional<Vector<Rational>> up = {};  ///< v, where θ is to its frame, as angle_to() has it
  /// f₂ of the frame of minimal twist at the end of an open path, projected; without it such a path
  /// has none on its page.
  std::optional<Vector<Rational>> end_normal = {};
  std::vector<GivenFrame> given = {};  ///< where there are some, there are rows at their t
};

/// All that a page about a path shows.
struct PageAnswer {
  AngleAnswer angle;  ///< what it is, with its formula where the path is a PH curve
  InfoAnswer info;    ///< its polynomials and totals
  /// What it gathers; not of many segments, of which that takes long.
  std::optional<TotalsAnswer> totals = {};
  std::optional<ClassificationAnswer> classification{};  ///< of a PH path, not too long
  std::vector<TabulatedFrame> frames;  ///< in the table, those that are somewhere defined
  /// t, r, e₁, the frames, s, curvature, torsion and theta; of a PH path theta_rate = dθ/dt and
  /// speed = |dr/dt|, too. With given frames these, g2 and g3, and error, the middle of the
  /// ball that the check has around the angle of g2 to the exact frame; elsewhere these are NaN, as
  /// undefined numbers are.
  FrameTable table;
  std::optional<CheckAnswer> check = {};  ///< of the given frames
  std::optional<Certificate> certificate =
      {};  ///< of θ at the end, from 0, of a PH curve of no high degree
  std::optional<CompiledAnswer> compiled = {};  ///< of paths of few segments
  bool is_closed = false;                       ///< its end is its start, with the same tangent
  std::vector<PageJump> jumps = {};  ///< at joints, where a number is another just before
  PathTurns turns = {};              ///< among the rows
};

/// The frames are rmf, erf or up, frenet, and exact_mtf: along a closed path the one that comes
/// back as it starts with the least turn, along an open one that with the end normal. Throws as
/// frame_table() and the other answers, and DomainError for an end normal along the tangent or of a
/// closed path.
PageAnswer answer(const NamedPath& path, const PageQuery& query);

}  // namespace phrame
