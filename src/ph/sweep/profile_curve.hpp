#pragma once
#include <vector>

#include "phrame/algebra/real.hpp"
#include "phrame/ph/sweep/profile.hpp"

namespace phrame::inline v0 {

/// A rational Bézier curve in the plane of a profile: Σ wₖPₖBₖ/Σ wₖBₖ.
struct PlaneBezier {
  std::vector<ProfilePoint> points;  ///< at least 2
  std::vector<Rational> weights;     ///< as many, > 0

  friend bool operator==(const PlaneBezier&, const PlaneBezier&) = default;
};

/// A curve (X, Y)/W.
struct PlaneRational {
  Polynomial x;       ///< X
  Polynomial y;       ///< Y
  Polynomial weight;  ///< W
};
/// The same curve from its end to its start.
PlaneBezier reversed(PlaneBezier bezier);
/// The curve on [0, 1] by polynomials.
PlaneRational polynomials(const PlaneBezier& bezier);
/// The Bézier curves of the parts of [0, 1] on which all Bernstein coefficients of W are > 0: it is
/// halved until they are. Requires W > 0 on [0, 1].
std::vector<PlaneBezier> bezier_pieces(const PlaneRational& curve);

/// What is swept exactly: a closed curve of rational Bézier curves, which may have holes.
class ProfileCurve {
 public:
  /// Of pieces that begin where the one before ends, the first where the last ends, in either
  /// direction. Throws DomainError where they do not, naming the piece, for weights that are not >
  /// 0, and where the area is 0; Undecided where that is not told. That the curve does not meet
  /// itself is for the caller to see to. Cost: the area, exactly.
  explicit ProfileCurve(std::vector<PlaneBezier> pieces);

  /// Of several such rings, in any order and each in either direction: the one of the greatest area
  /// goes around all the others, which are holes. That they lie so, and none in another, and do not
  /// meet, is for the caller to see to. Throws as above, naming the ring, and where the areas
  /// cannot be those of an outline and its holes.
  static ProfileCurve of_rings(std::vector<std::vector<PlaneBezier>> given);

  /// At least one: of the outer ring, counterclockwise, then of the holes, clockwise.
  const std::vector<PlaneBezier>& pieces() const { return pieces_; }
  /// Of each ring, the number of its first piece.
  const std::vector<std::size_t>& rings() const { return rings_; }
  const Real& area() const { return area_; }  ///< > 0, that of the holes left out

 private:
  ProfileCurve() = default;
  void append_ring(const std::vector<PlaneBezier>& pieces);

  std::vector<PlaneBezier> pieces_;
  std::vector<std::size_t> rings_;
  Real area_ = Rational(0);
};

/// Each ring in the other direction: the pieces reversed, from the last to the first.
std::vector<PlaneBezier> reversed_pieces(const ProfileCurve& profile);

/// The circle, in four quarters ((1 − u²), 2u)/(1 + u²) with rational weights. Throws DomainError
/// for a radius ≤ 0.
ProfileCurve circle_curve(const Rational& radius);
/// The sides of a polygon.
ProfileCurve polygon_curve(const Profile& polygon);

}  // namespace phrame
