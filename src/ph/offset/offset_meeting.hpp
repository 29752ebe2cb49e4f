#pragma once
#include "phrame/ph/curve/crossings.hpp"
#include "phrame/ph/offset/envelope.hpp"
#include "phrame/ph/offset/offset.hpp"

namespace phrame::inline v0 {

/// Where the offset meets itself, with segments that are pieces of it. Where a piece ends on
/// another one, both branches crossing there, that is one of the places; at a joint it is told of
/// the piece that begins there. The parameters of crossings are known to so many bits, if numbers
/// allow it.
SelfIntersections self_intersections(const Offset& offset, long bits = 64);

/// The parameters of the part.
Interval interval_of(const CurvePart& part);
/// A polynomial whose roots are the t at which the curve goes through the point, complex ones, too.
Polynomial visits_of(const RationalCurve& curve, const Vector<Rational>& at);
/// Those of them in an interval.
std::vector<RealAlgebraic> through(const RationalCurve& curve, const Vector<Rational>& at,
                                   const Interval& where);

/// The pieces of an envelope, or of one or several offsets, as curves.
struct OffsetBranches {
  std::vector<RationalCurve> curves;  ///< with H along e₁
  std::vector<std::size_t> behind;    ///< as CurveSeries has it
  /// Where in (0, 1) what they are offsets of turns back; empty where that is not known.
  std::vector<std::vector<RealAlgebraic>> turns = {};
};
/// With the law of branches at cusps, where it is known where the path turns back.
CurveSeries plane_series(const OffsetBranches& branches);
/// @{ Those of one.
OffsetBranches branches_of(const Offset& offset);
OffsetBranches branches_of(const Envelope& envelope);
/// @}
/// In as few paths as possible: cut where nothing is behind, and where one turns back at a joint.
std::vector<Path> joined_paths(const OffsetBranches& branches);
/// The same of these, which are the series, as far as it is asked for.
SelfIntersections self_intersections(const OffsetBranches& branches, const CurveSeries& series,
                                     CrossingQuery query);

}  // namespace phrame
