#pragma once
#include <memory>
#include <utility>

#include "phrame/ph/along/speed_limit.hpp"

namespace phrame::inline v0 {

/// The fastest motion along a path under a feedrate and limits of the acceleration: with w = v² as
/// a function of the arc length s it is the greatest w with
///   w ≤ V²,  κw ≤ A_n,  |dw/ds| ≤ 2A_t,  and the speeds that are given at the ends,
/// the least of B, the least of the first two bounds, and of the lines w(u) ± 2A_t(s − u) from all
/// points (u, B(u)) and from the ends. So it has parts on B and lines, which are found by proved
/// signs of B′ ± 2A_t and of differences: the motion is the fastest one itself, not one near it
/// [Bobrow, Dubowsky, Gibson 1985].
class SpeedProfile {
 public:
  /// Throws DomainError where a function that is the least limit is not positive and finite; where
  /// the speeds at the ends are too great; at a cusp, but under constants, and with a normal limit
  /// without a tangential one at a corner of more than 10⁻⁶ radians, where the motion stops.
  /// Throws Undecided where a sign is not told.
  SpeedProfile(const Path& path, const PathLength& length, const Feedrate& feedrate,
               const std::optional<Vector<Rational>>& normal);

  /// The time of the whole motion.
  Real total() const { return start(pieces_.size()); }
  /// The time from the start of the path to a place.
  Real time(const Place& at) const;
  /// The place and the arc length at a time within the motion.
  std::pair<Place, Real> at_time(const Rational& time) const;
  /// v at that time, at that place.
  Real speed(const Rational& time, const Place& at) const;

  /// A part of the path.
  struct Piece {
    std::optional<SpeedLimit> limit;  ///< on which v is; none where v² is linear
    std::size_t segment;              ///< of the limit
    Real t0, t1;                      ///< from where to where on that, if it is no constant
    Real s0, s1;                      ///< from where to where on the path
    Real w0, w1;                      ///< v² there
    int slope = 0;                    ///< 1 or −1 where that is linear, as it rises or falls
    std::shared_ptr<const SeriesIntegral> integral = nullptr;  ///< of 1/v, where v is no constant
    Real duration = Rational(0);
  };
  const std::vector<Piece>& pieces() const { return pieces_; }  ///< from the start to the end
  Real start(std::size_t piece) const;                          ///< the time there

 private:
  std::size_t piece_at(const Rational& time) const;
  Place place_at(const Real& s) const;

  Path path_;
  PathLength length_;
  std::optional<Rational> acceleration_;  ///< A_t
  std::vector<Piece> pieces_;
  struct Sums;
  std::shared_ptr<Sums> sums_;
};

}  // namespace phrame
