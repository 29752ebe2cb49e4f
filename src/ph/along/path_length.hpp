#pragma once
#include <memory>

#include "phrame/export.hpp"
#include "phrame/ph/along/arc_length.hpp"
#include "phrame/ph/curve/place.hpp"

namespace phrame::inline v0 {

/// The arc length ∫ |r′| dt along a path from its start, through cusps, too, and its inverse: a
/// polynomial along PH curves on which f keeps its sign. Copies are cheap and share what was found;
/// any thread may ask.
class PHRAME_API PathLength {
 public:
  /// Along this path.
  explicit PathLength(const Path& path);

  /// The length from the start of the path to a place. Exact where it is seen to be rational: along
  /// PH curves up to a rational t, if f changes its sign at rational t only, and on lines.
  Real value(const Place& at) const;
  /// The length up to the start of segment k; the whole length where k is the number of segments.
  Real before(std::size_t k) const;
  /// The length of segment k.
  Real of_segment(std::size_t k) const;
  /// The length of the whole path.
  Real total() const;
  /// The arc length along segment k from its start, if that is a PH curve on which f keeps its
  /// sign; else null.
  std::shared_ptr<const ArcLength> closed_form(std::size_t k) const;

  /// A ball around value(), also where value() is exact.
  RealBall enclose(const Place& at, long bits) const;
  /// ds/dt ≥ 0 on a ball of the parameter of a segment.
  RealBall rate(std::size_t segment, const RealBall& t, long bits) const;

  /// The place where the arc length from the start is s; at a joint it is on the later segment. For
  /// an s beyond the length that rounds to the same double it is the end. t is known to be
  /// algebraic along a PH curve where value() of rational t is exact. Throws DomainError for
  /// another s outside [0, total()]; Undecided where that, or the segment, is not told within 8192
  /// bits. The t is not for concurrent use.
  Place point(const Rational& s) const;

 private:
  std::optional<RealAlgebraic> root_near(std::size_t segment, const Real& t,
                                         const Rational& s) const;

  struct State;
  std::shared_ptr<State> state_;
};

}  // namespace phrame
