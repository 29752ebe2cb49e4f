#pragma once
#include <vector>

#include "phrame/algebra/real_algebraic.hpp"
#include "phrame/export.hpp"
#include "phrame/ph/curve/path.hpp"

namespace phrame::inline v0 {

/// r + d·n with n = (e₁y, −e₁x): a rational curve of degree 2·degree(curve) − 1 at most, with H
/// along e₁, whose points are at the distance |d| along the normal. To the right of travel for d >
/// 0; where the multiplier is negative, behind a cusp at which the curve turns back, e₁ is −r′/|r′|
/// and that is to the left: the offset is one curve through such cusps, as the frames are [Farouki,
/// Sakkalis 1990]. Throws DomainError for d = 0 and a curve in no plane z = const.
PHRAME_API RationalCurve offset(const Curve& curve, const Rational& d);

/// What joins the offsets of what meets at a corner, on its outer side.
enum class OffsetJoin {
  round,  ///< an arc about the corner
  mitre,  ///< the tangents, up to where they meet
  open    ///< nothing
};

/// A part of the offset of a path.
struct OffsetPiece {
  RationalCurve curve;   ///< with H along e₁ of the path
  std::size_t segment;   ///< that it is the offset of, or at whose start the corner is
  bool is_join = false;  ///< does it join others at that corner?
  std::vector<RealAlgebraic> turns = {};  ///< where in (0, 1) the path turns back, ascending
};

/// The offset of a path, with all that it has too much: cusps where the path is curved more than
/// 1/|d|, and what lies nearer to another part of the path than |d|.
struct Offset {
  Rational distance;                ///< d, > 0 to the right
  std::vector<OffsetPiece> pieces;  ///< in the order of the path
  /// Does each piece end where the next one starts, and the last one where the first one does?
  std::vector<bool> meets;
  std::vector<std::size_t> inner_corners;  ///< the segments at whose start there is one
};

/// The offset of a path of PH curves in one plane z = const, without arcs at the distance of their
/// centers, which become points: there it is cut. At corners it is joined as is asked
/// for on the outer side; on the inner side the offsets of both sides cross, as they are. Throws
/// DomainError as above.
PHRAME_API Offset offset(const PhPath& path, const Rational& d,
                         OffsetJoin join = OffsetJoin::round);

/// The offset, in as few paths as possible: it is cut where pieces are not joined, and where it
/// turns back at a joint. Straight pieces are PH curves.
PHRAME_API std::vector<Path> paths(const Offset& offset);
/// A curve of an offset as a segment, the PH curve that it is.
PHRAME_API Segment segment_of(const RationalCurve& curve);

/// A place where 1 + dκ = 0.
struct OffsetCusp {
  std::size_t piece;  ///< of the offset
  RealAlgebraic t;    ///< of it; 0 where it is at a joint
  bool turns_back;    ///< does the sign of 1 + dκ change?
};
/// All cusps, in their order along the offset, isolated by Sturm's theorem. At a joint, where the
/// curvature may jump, the offset may turn back though 1 + dκ ≠ 0 on either side: such a joint is
/// one of them.
PHRAME_API std::vector<OffsetCusp> cusps(const Offset& offset);

}  // namespace phrame
