#pragma once
#include <functional>

#include "phrame/ph/offset/offset_join.hpp"

namespace phrame::inline v0 {

/// Of what the offset of a path is made: a segment of that path, with its offset.
struct OffsetSegment {
  /// The offset, with H along e₁; none where it is a point, or there is none.
  std::optional<RationalCurve> curve;
  Vector<Rational> start;   ///< where the segment starts
  PlaneDirection at_start;  ///< e₁ there, of any length
  PlaneDirection at_end;    ///< e₁ at its end, likewise
  int sign;  ///< 1 where e₁ is r′/|r′| just after the start, −1 where it is the opposite
  std::vector<RealAlgebraic> turns;  ///< as OffsetPiece has them
};

/// The curve with H along e₁, which it is parallel to at its start.
RationalCurve with_direction(const RationalCurve& curve, const PlaneDirection& e1);

/// What joins the offsets of two segments, by their numbers, at the corner between them on its
/// outer side, with H along e₁; may be nothing.
using JoinAtCorner = std::function<std::vector<RationalCurve>(
    const PlaneCorner& corner, std::size_t before, std::size_t after)>;

/// The offset at d of a path of these segments, which closes or does not: cut where a segment has
/// none, and at corners where they are not joined.
Offset joined_offset(const Rational& d, std::vector<OffsetSegment> segments, bool is_closed,
                     const JoinAtCorner& join);

}  // namespace phrame
