#pragma once
#include <functional>

#include "phrame/ph/curve/crossings.hpp"

namespace phrame::inline v0 {

/// Two coordinates of a curve around a place of a segment.
using PlanePosition = std::function<std::array<BallPolynomial, 2>(
    std::size_t segment, const RealBall& t, long length, long bits)>;

/// A solution s = first, t = second of P(s) − Q(t) = 0 in two arcs.
struct NewtonStep {
  RealBall first;   ///< s
  RealBall second;  ///< t
};
/// N for the parameters in s and t, from their middles: a solution in s and t is in N, and there is
/// one where N is inside them.
NewtonStep newton(const PlanePosition& p, std::size_t first, const RealBall& s,
                  const PlanePosition& q, std::size_t second, const RealBall& t, long bits);

/// The coordinates in a plane z = const.
PlanePosition plane_position(const CurveSeries& curve);

/// Is segment b what is behind segment a?
bool goes_on_into(const CurveSeries& curve, std::size_t a, std::size_t b);

/// Have two parts a point in common as parts of one curve, as a part with itself has?
bool are_joined(const CurveSeries& curve, const CurvePart& a, const CurvePart& b);

/// Adds one to those that are sorted by first place, unless it is one of them.
void add_once(std::vector<Crossing>& found, const Crossing& crossing);

/// Pairs of arcs looked at in balls, with bits enough for arcs of 2^−64 of a segment: branches that
/// nearly touch are told apart there, or cross in places that are found, however near to each other
/// they are beside their coordinates.
class CloseSearch {
 public:
  explicit CloseSearch(const CurveSeries& curve);
  /// All crossings of two parts; no value where they are not told, or after too many of these.
  std::optional<std::vector<Crossing>> crossings(const CurvePart& a, const CurvePart& b);

 private:
  const CurveSeries& curve_;
  PlanePosition position_;
  long pairs_left_;
};

/// What self_intersections() left undecided is looked at so. What is decided is moved.
void look_closer(const CurveSeries& curve, SelfIntersections& result);

}  // namespace phrame
