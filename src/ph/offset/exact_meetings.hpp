#pragma once
#include <map>
#include <memory>
#include <optional>

#include "phrame/ph/offset/offset_meeting.hpp"

namespace phrame::inline v0 {

/// What two parts of boundary curves have in common.
struct PartMeetings {
  std::vector<Crossing> crossings;     ///< transversal ones
  std::vector<KnownMeeting> touching;  ///< where they touch and neither crosses the other
};

/// Decides by elimination where short parts meet, whatever is between them: P(s) = Q(t) are two
/// polynomials in s and t, and all s of common points are the roots of their resultant. Where that
/// has no root in a part, there is none, however near the curves are. Else each root s with each
/// root t of the other resultant is a place that has one common point or none: Newton's method
/// finds the simple ones, and of a multiple root it is decided in ℚ[s] modulo its minimal
/// polynomial whether both polynomials have a root t in common.
class ExactMeetings {
 public:
  ExactMeetings(const OffsetBranches& curves, const CurveSeries& series);
  ~ExactMeetings();
  ExactMeetings(const ExactMeetings&) = delete;
  ExactMeetings& operator=(const ExactMeetings&) = delete;

  /// No value where the parts are joined, the curves coincide, the resultant is too long (its
  /// degree times its bits above 4·10⁷), curves cross and have one tangent there, or three branches
  /// meet in one point and two of them touch. Cost: one or two resultants for each pair of curves,
  /// of degree 162 for offsets of quintics.
  std::optional<PartMeetings> between(const UndecidedCrossing& place);

 private:
  class Pair;

  Pair& pair_of(std::size_t first, std::size_t second);

  const OffsetBranches& curves_;
  const CurveSeries& series_;
  std::map<std::pair<std::size_t, std::size_t>, std::unique_ptr<Pair>> pairs_;
};

}  // namespace phrame
