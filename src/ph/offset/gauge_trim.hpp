#pragma once
#include "phrame/ph/offset/gauge.hpp"
#include "phrame/ph/offset/trim_measure.hpp"

namespace phrame::inline v0 {

/// The offset of a path under a gauge without all points that are nearer to any point of the path
/// than |d| in its norm, |v| = the least c ≥ 0 with v in c·U and its inside: as that of a PH path
/// with the Euclidean one, which it is for the unit circle. Throws DomainError as GaugeOffsets, for
/// a path of which a segment has no rational offset; Undecided as the other one.
TrimmedOffset trimmed_offset(const Path& path, const Gauge& gauge, const Rational& d,
                             OffsetJoin join = OffsetJoin::round);

/// The Euclidean length of a branch, and its area, as those of the curves that it is.
BranchMeasure measure(const TrimmedOffset& trimmed, const TrimmedBranch& branch);

}  // namespace phrame
