#pragma once
#include "phrame/ph/offset/boundary.hpp"

namespace phrame::inline v0 {

/// What is left of an offset without all that is nearer to the path than |d|.
struct TrimmedOffset {
  Offset offset;                            ///< all of it, with round joins or mitres
  std::vector<TrimmedBranch> branches;      ///< by the places where they start
  std::vector<UndecidedStretch> undecided;  ///< mostly none: where branches touch
};

/// The offset of a path in a plane z = const, joined at corners by arcs or, where that is asked
/// for, by mitres or left open there, without all points that are nearer to any point of the path
/// than |d|, or between a mitre and the path. That is cut at crossings of the offset with itself,
/// with that to the other side and with the half-circles about the ends of an open path and about
/// places where it turns back, and at cusps, all of which are found with proof; between these the
/// distance of one rational point is compared with |d|, exactly. Of branches that coincide both are
/// left where their e₁ are opposite, as they are at the distance |d| from both sides, and one where
/// they are alike. Branches of a path that turns back go along e₁, or all against it, as the path
/// starts. Throws DomainError as offset(); Undecided where so many branches touch that the search
/// is cut off. Cost: pairs of short arcs whose boxes meet, where no
/// point of the path is seen to be nearer.
TrimmedOffset trimmed_offset(const PhPath& path, const Rational& d,
                             OffsetJoin join = OffsetJoin::round);

/// Its branches without what joins offsets at corners.
std::vector<TrimmedBranch> without_joins(const TrimmedOffset& trimmed);

/// The branch as a path, in several where it turns back at a cut. It is the offset itself, exactly,
/// where it is cut at rational parameters. Where it is cut elsewhere, the parameters are rounded to
/// so many digits and some more, so that the parts are on the offset still, and the ends that meet
/// there are moved to one point, by less than 10^−digits·|d|.
std::vector<Path> paths(const TrimmedOffset& trimmed, const TrimmedBranch& branch, long digits);

}  // namespace phrame
