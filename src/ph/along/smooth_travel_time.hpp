#pragma once
#include <memory>

#include "phrame/ph/along/feedrate.hpp"
#include "phrame/ph/along/path_length.hpp"

namespace phrame {

/// The time T(t) = ∫ |r′|/V dt a motion with feedrate V takes from the start of a path of any kind
/// to t, strictly increasing, and its inverse: as TravelTime along a PH path, without a closed
/// form. The arc length and the parameter that V may depend on are those of the whole path; the
/// curvature is that in its plane, whose unit normal has a positive last component that is not 0.
/// To move one is to copy it.
class SmoothTravelTime {
 public:
  /// Throws DomainError where V is not positive and finite all along; and of the curvature where
  /// the path is in no plane, or has a cusp. Throws Undecided where that is not told. That of V(s)
  /// and V(t) is decided by algebra, of V(κ) by Taylor series in balls.
  SmoothTravelTime(const Path& path, const Feedrate& feedrate);
  SmoothTravelTime(const SmoothTravelTime&) = default;
  SmoothTravelTime& operator=(const SmoothTravelTime&) = default;
  ~SmoothTravelTime() = default;

  const PathLength& length() const;  ///< the arc length along the path
  /// T there; exact where it is seen to be rational.
  Real time(const Place& at) const;
  const Real& total() const;  ///< T at the end

  /// A point of the path and the arc length up to it.
  struct Point {
    Place at;
    Real arc_length;
  };
  /// Where T = time, at a joint on the later segment. Requests in ascending order are the fastest.
  /// The end for a time of which is_rounded_total() is true. Throws DomainError for another time
  /// outside [0, total()], Undecided where that, or the segment, is not told. The point is not for
  /// concurrent use.
  Point at_time(const Rational& time) const;

 private:
  struct State;
  std::shared_ptr<State> state_;
};

}  // namespace phrame
