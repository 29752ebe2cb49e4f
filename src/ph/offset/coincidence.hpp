#pragma once
#include <map>
#include <set>
#include <vector>

#include "phrame/algebra/bivariate.hpp"
#include "phrame/ph/curve/curve_arc.hpp"
#include "phrame/ph/offset/offset_meeting.hpp"

namespace phrame::inline v0 {

/// P(s) = Q(t) of two curves in a plane z = const, as f = g = 0, polynomials in t over ℚ[s].
struct MeetingEquations {
  Bivariate f;                    ///< without what both have in common
  Bivariate g;                    ///< likewise
  std::vector<Bivariate> shared;  ///< the irreducible factors of that; none is s − t of one curve
};
/// Of one curve with itself they are divided by s − t. Cost: a gcd of polynomials in two unknowns.
MeetingEquations meeting_equations(const RationalCurve& a, const RationalCurve& b,
                                   bool is_one_curve);

/// Is a polynomial linear in s and in t?
bool is_bilinear(const Bivariate& factor);
/// May such a factor be 0 in the rectangle? If it is bilinear, as where each curve goes through its
/// points once, it is 0 there if this is true, perhaps in a corner.
bool may_vanish(const Bivariate& factor, const Interval& s, const Interval& t);

/// Which parts of curves coincide, whatever their parameters: P(s) = Q(t) all along where one of
/// both is a fraction a(s)/b(s) of linear polynomials, a bilinear factor of both equations. Lines
/// that are gone along in any manner without turning back do between their common ends.
class Coincidences {
 public:
  /// Of other curves none where the factors are of higher degree. Cost: a gcd modulo a prime for
  /// each two curves of which one ends in the box of the other, and where that is not 1 the
  /// equations; of lines up to four polynomials of their degree are factored.
  Coincidences(const OffsetBranches& branches, const CurveSeries& series);

  const std::vector<CoincidentParts>& parts() const { return parts_; }  ///< by segments
  /// Are arcs parts of one curve that hang together and go one way, or turn back once and turn one
  /// way, so that all that they have in common coincides?
  bool cover(const CurveNode& a, const CurveNode& b) const;

 private:
  void add(std::size_t first, std::size_t second, const std::vector<RationalCurve>& curves);

  bool add_lines(std::size_t first, std::size_t second, const std::vector<RationalCurve>& curves);
  bool turn_back_at_once(const CurveNode& a, const CurveNode& b, const Bivariate& factor) const;

  std::vector<SegmentTurning> turning_;  ///< of all curves
  std::vector<CoincidentParts> parts_;
  std::set<std::pair<std::size_t, std::size_t>> lines_;  ///< that have a part in common
  std::map<std::pair<std::size_t, std::size_t>, std::vector<Bivariate>> factors_;
};

}  // namespace phrame
