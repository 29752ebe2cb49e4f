#pragma once
#include <map>
#include <memory>
#include <optional>

#include "phrame/ph/offset/offset_meeting.hpp"

namespace phrame::inline v0 {

/// What two parts of boundary curves have in common.
struct PartMeetings {
  std::vector<Crossing> crossings;     ///< transversal ones
  std::vector<KnownMeeting> touching;  ///< where they have one tangent
};

/// Does a curve go through the point of another one at s, at a t in the interval? Precondition: at
/// one such t at most, without turning back or touching there. Cost: a gcd in ℚ(s)[t].
bool passes_through(const RationalCurve& curve, const Interval& t, const RationalCurve& other,
                    const RealAlgebraic& s);

/// The t at which a curve meets another one, or itself: the only root of a resultant in the ball.
/// No value where there are more of them, or the resultant is too long.
std::optional<RealAlgebraic> exact_place(const RationalCurve& curve, const RationalCurve& other,
                                         const RealBall& t);

/// Decides by elimination where short parts meet, whatever is between them: P(s) = Q(t) are two
/// polynomials in s and t, and all s of common points are the roots of their resultant. Where that
/// has no root in a part, there is none, however near the curves are. Else each root s with each
/// root t of the other resultant is a place that has one common point or none: Newton's method
/// finds the simple ones, and of multiple roots it is decided in ℚ[s] modulo the minimal polynomial
/// of s whether t is one of the common roots of both polynomials there. Ends that are one joint,
/// and s = t of one curve with itself, are no common points.
class ExactMeetings {
 public:
  ExactMeetings(const OffsetBranches& curves, const CurveSeries& series);
  ~ExactMeetings();
  ExactMeetings(const ExactMeetings&) = delete;
  ExactMeetings& operator=(const ExactMeetings&) = delete;

  /// Of parts that coincide what they have in common elsewhere. No value where that factor of both
  /// equations is not linear in s and t, or the resultant is too long: its degree times its bits
  /// above 2·10⁷, or of all together above 2·10⁸. Cost: one or two resultants for each pair of
  /// curves, of degree 108 for offsets of quintics.
  std::optional<PartMeetings> between(const UndecidedCrossing& place);

  /// Are the resultants of these two curves short, as those of lines with others are?
  bool is_quick(const UndecidedCrossing& place) const;

 private:
  class Pair;

  Pair& pair_of(std::size_t first, std::size_t second);

  const OffsetBranches& curves_;
  const CurveSeries& series_;
  long bits_left_ = 200'000'000;  ///< of resultants
  std::map<std::pair<std::size_t, std::size_t>, std::unique_ptr<Pair>> pairs_;
};

}  // namespace phrame
