#pragma once
#include <array>
#include <map>
#include <set>
#include <vector>

#include "phrame/algebra/bivariate.hpp"
#include "phrame/algebra/rational_function.hpp"
#include "phrame/ph/curve/curve_arc.hpp"
#include "phrame/ph/offset/offset_meeting.hpp"

namespace phrame::inline v0 {

/// One coordinate of P(s) − Q(t), times both weights: a polynomial in t over ℚ[s].
Bivariate meeting_gap(const RationalCurve& a, const RationalCurve& b, std::size_t coordinate);

/// P(s) = Q(t) of two curves in a plane z = const, as f = g = 0.
struct MeetingEquations {
  Bivariate f;                    ///< without what both have in common
  Bivariate g;                    ///< likewise
  std::vector<Bivariate> shared;  ///< the irreducible factors of that; none is s − t of one curve
};
/// Of one curve with itself they are divided by s − t. Cost: a gcd of polynomials in two unknowns.
MeetingEquations meeting_equations(const RationalCurve& a, const RationalCurve& b,
                                   bool is_one_curve);

/// Is a curve in a plane z = const on a straight line?
bool is_straight(const RationalCurve& curve);

/// Does a curve that turns back at t go back along itself, as a line does?
bool goes_back_at(const RationalCurve& curve, const RealAlgebraic& t);

/// Is a polynomial linear in s and in t?
bool is_bilinear(const Bivariate& factor);
/// May such a factor be 0 in the rectangle? If it is bilinear, as where each curve goes through its
/// points once, it is 0 there if this is true, perhaps in a corner.
bool may_vanish(const Bivariate& factor, const Interval& s, const Interval& t);

/// A part of a curve on which that goes one way along the algebraic curve that it is on.
struct CurveLeg {
  RealAlgebraic from;   ///< its parameter where it starts
  RealAlgebraic to;     ///< and where it ends, greater
  RealAlgebraic start;  ///< that of the algebraic curve there
  RealAlgebraic end;    ///< likewise
};
/// Where an algebraic curve turns back, at a cusp.
struct CurveTip {
  RealAlgebraic t;   ///< on a curve along it
  RealAlgebraic at;  ///< by its own parameter
};
/// How a curve C(t) goes along an algebraic one, which it may do to and fro.
struct CurveCourse {
  /// h with C(t) = C₀(h(t)), where C₀ goes through nearly all points once: x of a line, or y of one
  /// along y.
  RationalFunction along;
  std::vector<CurveLeg> legs;  ///< between the places where it turns back along that
  std::vector<CurveTip> tips;  ///< where it comes to such places, ascending; of a line none
};

/// Which parts of curves coincide, whatever their parameters: P(s) = Q(t) all along where one of
/// both is a fraction a(s)/b(s) of linear polynomials, a bilinear factor of both equations, where
/// each curve goes through its points once. Lines, and curves that go through their points more
/// than once, are gone along in any manner, also there and back: of both C₀(h(s)) = C₀(k(t)) all
/// along h(s) = k(t), by Lüroth's theorem, and each two of their legs coincide between their common
/// ends, or have one point in common.
class Coincidences {
 public:
  /// Where none of some h and k have no pole, as of curves that go all around a loop more than
  /// once, nothing is told of these. Cost: a gcd modulo a prime for each two curves of which one
  /// ends in the box of the other, and where that is not 1 the equations; of legs of lines up to
  /// four polynomials of their degree are factored.
  Coincidences(const OffsetBranches& branches, const CurveSeries& series);
  Coincidences() = default;  ///< none

  /// Are there none, and no parallel lines, either?
  bool are_none() const { return lines_.empty() && factors_.empty() && courses_.empty(); }

  const std::vector<CoincidentParts>& parts() const { return parts_; }  ///< by segments
  /// Where legs of lines have one point in common, as joints may be, too.
  const std::vector<KnownMeeting>& points() const { return points_; }
  /// Is all known that arcs have in common? So it is of parallel lines, and of parts of one curve
  /// that hang together and go one way, or turn back once and turn one way.
  bool cover(const CurveNode& a, const CurveNode& b) const;

 private:
  bool is_straight(std::size_t k) const;
  /// With at most one t of the second curve for a point of the first, complex ones counted, if
  /// that is known.
  void add(std::size_t first, std::size_t second, const std::vector<RationalCurve>& curves,
           bool is_visited_once);
  void add_lines(std::size_t first, std::size_t second, const std::vector<RationalCurve>& curves);
  bool add_courses(std::size_t first, std::size_t second, const std::vector<Bivariate>& shared,
                   const std::vector<RationalCurve>& curves);
  void add_legs(std::size_t first, const CurveCourse& a, std::size_t second, const CurveCourse& b,
                const std::vector<RationalCurve>& curves);
  const CurveCourse& course_of_line(std::size_t line, const RationalCurve& curve);
  bool has_cusp(const CurveNode& arc) const;
  bool turn_back_at_once(const CurveNode& a, const CurveNode& b, const Bivariate& factor) const;

  std::vector<SegmentTurning> turning_;  ///< of all curves
  std::vector<CoincidentParts> parts_;
  std::vector<KnownMeeting> points_;
  std::map<std::size_t, CurveCourse> courses_of_lines_;
  std::set<std::pair<std::size_t, std::size_t>> lines_;  ///< that are parallel
  std::map<std::pair<std::size_t, std::size_t>, std::vector<Bivariate>> factors_;
  /// Of two curves of which one goes through its points more than once.
  std::map<std::pair<std::size_t, std::size_t>, std::array<CurveCourse, 2>> courses_;
};

}  // namespace phrame
