#pragma once
#include <optional>
#include <string>

#include "phrame/export.hpp"
#include "phrame/ph/curve/path.hpp"
#include "phrame/ph/curve/rational_bezier.hpp"

namespace phrame::inline v0 {

/// A B-spline curve, or NURBS, of degree p: with the knots u₀ ≤ u₁ ≤ …, control points P₀ … P_n and
/// weights, the curve Σ N_k(u) w_k P_k / Σ N_k(u) w_k on [u_p, u_{n+1}], N_k the B-splines of
/// degree p on u_k … u_{k+p+1}. Knots may be clamped or not, of any distances. [Piegl, Tiller: The
/// NURBS Book, chapters 2 to 4].
struct BSpline {
  long degree = 3;  ///< p ≥ 1
  /// n + p + 2 of them; or n + p, without the outermost two, which no point of the curve depends on
  /// (as in files of openNURBS).
  std::vector<Rational> knots;
  std::vector<Vector<Rational>> points;  ///< n + 1 ≥ p + 1 of them
  std::vector<Rational> weights = {};    ///< n + 1 numbers > 0; none: all are 1
};

/// What keeps a BSpline from being a curve.
struct BSplineFault {
  /// The member that is wrong.
  enum class Member { degree, knots, points, weights };
  Member member;                     ///< where
  std::optional<std::size_t> index;  ///< the entry, where it is one
  std::string reason;                ///< one line, without the place
};
/// The first fault, in the order of Member; no value where there is none. Wrong are counts,
/// decreasing knots, an empty [u_p, u_{n+1}], knots of a multiplicity above p + 1, or inside above
/// p, where the curve would be in two parts, and weights ≤ 0: with weights > 0 the denominator has
/// no zero.
PHRAME_API std::optional<BSplineFault> fault_of(const BSpline& spline);

/// The part of a B-spline between two successive knots, as a Bézier curve on [0, 1].
struct BezierPiece {
  RationalBezier curve;  ///< of degree p
  Rational lower;        ///< the knot where it begins
  Rational upper;        ///< the next greater one
};
/// The parts of the curve between successive knots of its domain, exactly, by the blossom b of
/// each: the control points are b(uᵢ, …, uᵢ, uᵢ₊₁, …, uᵢ₊₁) [Ramshaw 1989]. Costs p² combinations
/// of two points for each. Throws DomainError with the fault_of() the spline.
PHRAME_API std::vector<BezierPiece> bezier_pieces(const BSpline& spline);

/// The path as one curve with weights > 0, exactly, clamped, with joints of multiplicity p at knots
/// 0, 1, …: of the greatest degree of its segments, cut where a weight would not be > 0. Throws
/// DomainError for segments by formulas.
PHRAME_API BSpline as_bspline(const Path& path);

}  // namespace phrame
