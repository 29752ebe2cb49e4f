#pragma once
#include <functional>
#include <optional>
#include <utility>
#include <vector>

#include "phrame/ph/curve/curve_series.hpp"

namespace phrame::inline v0 {

struct CurveNode;

/// Two places of curves that a projection along v lays over each other.
struct Crossing {
  std::size_t first_segment;   ///< of the first curve
  RealBall first_t;            ///< the parameter there
  std::size_t second_segment;  ///< of the second curve, or of the same one
  RealBall second_t;           ///< the parameter there
  int sign;                    ///< that of det(r′(first), r′(second), r(first) − r(second))
};

/// All crossings, each once: that each of these is one, and that there are no others, is proved,
/// by Newton's method in intervals on pairs of arcs [Moore, Krawczyk]. Closed curves are meant,
/// which may have corners. No value where that is not decided within arcs of 2^−30 of a segment:
/// where the projection touches itself, has a cusp or has a crossing at an end of an arc, so that
/// another v is to be tried; or where the curve meets itself, or nearly so.
std::optional<std::vector<Crossing>> self_crossings(const CurveSeries& curve,
                                                    const Vector<Rational>& v);
/// The crossings of one curve with another, likewise.
std::optional<std::vector<Crossing>> mutual_crossings(const CurveSeries& first,
                                                      const CurveSeries& second,
                                                      const Vector<Rational>& v);

/// A part [lower, upper] of a segment.
struct CurvePart {
  std::size_t segment;  ///< 0, 1, …
  double lower;         ///< of its parameter
  double upper;         ///< likewise
};
/// Two parts, or one and itself, of which it is not told whether they meet.
struct UndecidedCrossing {
  CurvePart first;   ///< the earlier one
  CurvePart second;  ///< the later one
};
/// Two places of a curve that are known to be one point, exactly.
struct KnownMeeting {
  std::size_t first_segment;   ///< the segment of one
  RealAlgebraic first_t;       ///< and its parameter
  std::size_t second_segment;  ///< those of the other, which is not before it
  RealAlgebraic second_t;      ///< likewise
  bool crosses = false;        ///< of branches with one tangent: does each cross the other there?
};
/// Two parts of a curve that are one set of points: from and to are one point each.
struct CoincidentParts {
  std::size_t first_segment;   ///< the segment of one
  RealAlgebraic first_from;    ///< where it starts there
  RealAlgebraic first_to;      ///< and ends, at a greater parameter
  std::size_t second_segment;  ///< that of the other, which is not before it
  RealAlgebraic second_from;   ///< likewise
  RealAlgebraic second_to;     ///< less than second_from where it goes the other way
  bool is_alike = true;        ///< does H point the same way along both?
};
/// Where a plane curve meets itself.
struct SelfIntersections {
  /// Each once, by first place, with the sign of r′(first) × r′(second).
  std::vector<Crossing> found;
  std::vector<KnownMeeting> touching = {};       ///< where branches of offsets have one tangent
  std::vector<CoincidentParts> coincident = {};  ///< and where they are one
  std::vector<UndecidedCrossing> undecided;  ///< parts of less than 2^−24 of a segment, by place
  bool is_cut_off = false;  ///< was there so much undecided that the rest was not looked at?
  bool is_complete() const { return undecided.empty() && !is_cut_off; }  ///< are these all?
};
/// What is known of the places where a curve meets itself, and which of them are asked for.
struct CrossingQuery {
  std::vector<KnownMeeting> known = {};  ///< meetings that are not to be found again
  /// Is nothing asked of a part? Then of none of its parts.
  std::function<bool(const CurveNode&)> is_idle = {};
  /// Is nothing asked of where two arcs meet?
  std::function<bool(const CurveNode&, const CurveNode&)> are_idle = {};
  /// The same of a part, by a closer look, beside a short arc that nearly coincides with it.
  std::function<bool(const CurveNode&, const CurveNode&)> is_idle_beside = {};
  /// Where a curve turns back, is nothing asked of one of the two branches, up to a break?
  bool is_idle_beyond_reversals = false;
  /// Are nearly parallel arcs looked at in balls at once, as is worth it next to near-cusps, where
  /// there are many? Else once all others are.
  bool has_near_cusps = false;
};
/// All places where a curve in a plane z = const meets itself, open or closed, with cusps and
/// corners, proved like self_crossings(): at a place that is found there is one point in common,
/// which both branches cross, and elsewhere there is none but in undecided parts, as where it
/// touches itself or ends on itself. The turning of the curve is wanted (plane_series()). Where
/// both branches cross at a meeting that is known, it is not found again, nor undecided.
SelfIntersections self_intersections(const CurveSeries& curve, const CrossingQuery& query = {});

/// The parameters of a crossing in the plane to so many bits, by Newton's method in intervals.
std::pair<RealBall, RealBall> narrowed(const CurveSeries& curve, const Crossing& crossing,
                                       long bits);

/// The sum of the signs: for a curve with itself the linking number of the curve with its copy
/// shifted along v, and for two curves twice their linking number.
long sum_of_signs(const std::vector<Crossing>& crossings);

}  // namespace phrame
