#pragma once
#include <array>
#include <optional>
#include <vector>

#include "phrame/algebra/rational.hpp"
#include "phrame/export.hpp"

namespace phrame::inline v0 {

/// A point of the plane of a profile: its coordinates along f₂ and f₃.
using ProfilePoint = std::array<Rational, 2>;

/// What is swept along a curve: a simple polygon, which may have holes and stand for a curve.
class PHRAME_API Profile {
 public:
  /// The polygon with these corners, in either direction; the last may be the first again. `error`
  /// bounds the distance of the polygon from the curve that it stands for, if any, both ways, and
  /// `angle` that of each side from its part of the curve. Throws DomainError, which names the
  /// corners, for fewer than three, for two that are the same, and for sides that meet elsewhere
  /// than at a corner between them. Cost: quadratic in the number of corners, with a small
  /// constant.
  explicit Profile(std::vector<ProfilePoint> corners, Rational error = 0, Rational angle = 0);

  /// The region between several rings of corners, in any order and each in either direction: one
  /// goes around all the others, which are holes. Throws DomainError as above, naming the ring
  /// where there are several; for rings that meet, and where no ring goes around all others or one
  /// of these goes around another.
  static Profile of_rings(std::vector<std::vector<ProfilePoint>> rings, const Rational& error = 0,
                          const Rational& angle = 0);

  /// At least 3: of the outer ring, counterclockwise, then of the holes, clockwise.
  const std::vector<ProfilePoint>& corners() const { return corners_; }
  const Rational& error() const { return error_; }  ///< ≥ 0
  /// In radians, ≥ 0; beyond π none is known.
  const Rational& angle() const { return angle_; }
  /// The corner after this one.
  std::size_t next(std::size_t corner) const { return next_[corner]; }
  /// The number of the first corner of each ring.
  const std::vector<std::size_t>& rings() const { return rings_; }
  /// No corner is farther from the origin.
  double reach() const;

 private:
  friend PHRAME_API Profile subdivided(const Profile& profile, const std::vector<long>& pieces);
  Profile(Rational error, Rational angle) : error_(std::move(error)), angle_(std::move(angle)) {}
  /// As it is.
  void append_ring(std::vector<ProfilePoint> corners);

  std::vector<ProfilePoint> corners_;
  std::vector<std::size_t> next_;
  std::vector<std::size_t> rings_;
  Rational error_;
  Rational angle_;
};

/// A regular polygon with a corner at (radius, 0), its others rounded to doubles. Throws
/// DomainError for fewer than 3 corners and a radius ≤ 0.
PHRAME_API Profile regular_polygon(long corners, const Rational& radius);
/// A polygon within `tolerance` > 0 of the circle, and within the angle where one is given, > 0, at
/// least a hexagon, with so many corners as that needs. Throws DomainError for a radius ≤ 0, and
/// where these are more than 10 000.
PHRAME_API Profile circle_profile(const Rational& radius, const Rational& tolerance,
                                  const std::optional<Rational>& angle = std::nullopt);
/// With its center at the origin. Throws DomainError unless both are > 0.
PHRAME_API Profile rectangle_profile(const Rational& width, const Rational& height);

/// The same with each side in so many equal pieces, ≥ 1 of them.
PHRAME_API Profile subdivided(const Profile& profile, const std::vector<long>& pieces);

}  // namespace phrame
