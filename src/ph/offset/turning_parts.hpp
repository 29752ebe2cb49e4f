#pragma once
#include <vector>

#include "phrame/ph/curve/ph_path.hpp"
#include "phrame/ph/offset/offset_meeting.hpp"

namespace phrame::inline v0 {

/// A part of a segment of a path.
struct SegmentPart {
  std::size_t segment;  ///< of the path
  Rational lower;       ///< of its parameter
  Rational upper;       ///< likewise
};
/// The parameter of the segment at t of a part.
RealBall on_segment(const SegmentPart& part, const RealBall& t, long bits);
/// A path in parts, which are segments of the same path with more joints.
struct PathInParts {
  PhPath path;                     ///< of a segment for each part
  std::vector<SegmentPart> parts;  ///< what these are of the path that was given
};

/// Where [0, 1] is cut into parts on each of which ∫ turn/σ is seen to be between −1 and 1, the
/// ends 0 and 1 included. Precondition: σ > 0 on [0, 1].
std::vector<Rational> turning_cuts(const Polynomial& turn, const Polynomial& sigma);

/// A path in a plane z = const in parts on each of which the tangent is seen to turn by little.
/// Next to a near-cusp, where a segment turns within ε of its parameter, they get shorter by
/// halves: about log₂ 1/ε on each side of it.
PathInParts in_turning_parts(const PhPath& path);

/// The pieces of an offset in such parts.
struct BranchesInParts {
  OffsetBranches branches;         ///< a curve for each part
  std::vector<SegmentPart> parts;  ///< what these are, with the pieces for segments
};
/// The cuts of each of them. Costs more than for a path, whose σ has half the degree.
std::vector<std::vector<Rational>> turning_cuts(const OffsetBranches& pieces);
/// Cut there.
BranchesInParts in_parts(const OffsetBranches& pieces,
                         const std::vector<std::vector<Rational>>& cuts);

}  // namespace phrame
