#pragma once
#include <memory>

#include "phrame/ph/curve/place.hpp"

namespace phrame {

/// The arc length ∫ |r′| dt along a path of any kind from its start, through cusps, too, and its
/// inverse. Copies are cheap and share what was found; any thread may ask.
class SmoothLength {
 public:
  /// Along this path.
  explicit SmoothLength(const Path& path);

  /// From the start of the path to there; exact where it is seen to be rational, as on lines.
  Real value(const Place& at) const;
  /// Up to the start of segment k, the end of the path for k = the number of segments.
  Real before(std::size_t k) const;
  /// Of segment k.
  Real of_segment(std::size_t k) const;
  /// Of the whole path.
  Real total() const;

  /// ds/dt ≥ 0 on a ball of the parameter of a segment.
  RealBall rate(std::size_t segment, const RealBall& t, long bits) const;

  /// Where the arc length from the start is s; the end for an s beyond it that rounds to the same
  /// double. Throws DomainError for another s outside [0, total()], Undecided where that, or which
  /// segment it is, is not told within 8192 bits. The t is not for concurrent use.
  Place point(const Rational& s) const;

 private:
  struct State;
  std::shared_ptr<State> state_;
};

}  // namespace phrame
