#pragma once
#include <array>
#include <cstdint>
#include <optional>
#include <vector>

#include "phrame/algebra/rational.hpp"

namespace phrame {

/// A point of the plane of a profile: so much along f₂, so much along f₃.
using ProfilePoint = std::array<Rational, 2>;

/// What is swept along a curve: a simple polygon, counterclockwise, which may stand for a curve.
class Profile {
 public:
  /// With these corners, in either order; that the last is the first again does not matter. The
  /// curve that it stands for, if any, has no point farther from the polygon than the error, and
  /// conversely, and each side has no greater angle to its part of the curve. Throws DomainError
  /// for fewer than three corners, for two of them that are the same, and for sides that meet
  /// elsewhere than at a corner between them; it names them. Cost: quadratic in the number of
  /// corners, with a small constant.
  explicit Profile(std::vector<ProfilePoint> corners, Rational error = 0, Rational angle = 0);

  const std::vector<ProfilePoint>& corners() const { return corners_; }  ///< at least 3
  const Rational& error() const { return error_; }                       ///< ≥ 0
  /// In radians, ≥ 0; beyond π none is known.
  const Rational& angle() const { return angle_; }
  /// The corner after this one.
  std::size_t next(std::size_t corner) const { return (corner + 1) % corners_.size(); }
  /// No corner is farther from the origin.
  double reach() const;

 private:
  std::vector<ProfilePoint> corners_;
  Rational error_;
  Rational angle_;
};

/// A regular polygon with a corner at (radius, 0), its others rounded to doubles. Throws
/// DomainError for fewer than 3 corners and a radius ≤ 0.
Profile regular_polygon(long corners, const Rational& radius);
/// A polygon within `tolerance` > 0 of the circle, and within the angle where one is given, > 0, at
/// least a hexagon, with so many corners as that needs. Throws DomainError for a radius ≤ 0, and
/// where these are more than 10 000.
Profile circle_profile(const Rational& radius, const Rational& tolerance,
                       const std::optional<Rational>& angle = std::nullopt);
/// With its center at the origin. Throws DomainError unless both are > 0.
Profile rectangle_profile(const Rational& width, const Rational& height);

/// The same with each side in so many equal pieces, ≥ 1 of them.
Profile subdivided(const Profile& profile, const std::vector<long>& pieces);

/// Triangles of corners, counterclockwise, that fill the polygon; decided exactly, by clipping ears
/// [Meisters 1975]. None is degenerate. Cost: the number of corners times that of the reflex ones.
std::vector<std::array<std::uint32_t, 3>> triangulated(const Profile& profile);

}  // namespace phrame
