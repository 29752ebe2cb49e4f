#pragma once
#include <variant>

#include "phrame/export.hpp"
#include "phrame/ph/curve/nearness.hpp"
#include "phrame/ph/curve/ph_path.hpp"

namespace phrame::inline v0 {

/// The greatest degree of curves that are taken here.
inline constexpr long max_near_degree = 101;

/// An exact PH curve near a polynomial curve on [0, 1].
struct NearCurve {
  Curve curve;        ///< exact
  Nearness nearness;  ///< to what was given
};

/// A PH curve near the curve with the hodograph r′ ≠ 0 and r(0) = start: the control points are at
/// most ε > 0 away, the first not at all. The preimage has the fewest bits for that. What is said
/// of it is proved; that there is no nearer one is not. Throws DomainError for r′ = 0, for ε ≤ 0
/// and for a degree > max_near_degree.
PHRAME_API std::variant<NearCurve, NotNear> near_curve(const Vector<Polynomial>& hodograph,
                                                       const Vector<Rational>& start,
                                                       const Rational& epsilon);

/// What one might ask near_curve() for: a power of ten, which is enough, and a bound of the
/// distance of the curve that is then to be had, before its bits are taken off.
struct NearSuggestion {
  Rational epsilon;   ///< 10ᵏ
  Rational distance;  ///< ≤ epsilon
};
/// No value where the curve is farther from being PH than a 1000th of its size, and above the
/// degree 45, since that takes long.
PHRAME_API std::optional<NearSuggestion> near_suggestion(const Vector<Polynomial>& hodograph,
                                                         const Vector<Rational>& start);

/// An exact PH spline near several polynomial curves, each on its own [0, 1].
struct NearPath {
  PhPath path;        ///< exact
  Nearness nearness;  ///< to what was given
};

/// The same for curves, at least one, that follow one another, by their control points. The joints
/// of the spline are exact: one position, one tangent, and one derivative where those given agree
/// within what ε makes of them. Each segment starts where the one before ends, and aims at the
/// points given, so that distances do not add up. The ends of the spline need not meet exactly if
/// those of the curves do. Throws DomainError where the tangent breaks and at a cusp at a joint,
/// too. Joints come from doubles, so that ε is to be 1e-15 of the size at least.
PHRAME_API std::variant<NearPath, NotNear> near_path(
    const std::vector<std::vector<Vector<Rational>>>& curves, const Rational& epsilon);

}  // namespace phrame
