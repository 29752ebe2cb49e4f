#pragma once
#include <variant>

#include "phrame/export.hpp"
#include "phrame/ph/curve/nearness.hpp"
#include "phrame/ph/curve/path.hpp"

namespace phrame::inline v0 {

/// The greatest degree of the curves that near_curve() and near_path() take.
inline constexpr long max_near_degree = 101;

/// An exact PH curve near a polynomial curve on [0, 1].
struct NearCurve {
  Curve curve;        ///< exact
  Nearness nearness;  ///< to what was given
};

/// A PH curve near the curve with the hodograph r′ ≠ 0 and r(0) = start: each control point is at
/// most ε > 0 from the one given, and the first is equal to it. The coefficients of the preimage
/// have as few bits as that allows. The distances are proved; that no PH curve is nearer is not.
/// Throws DomainError for r′ = 0, for ε ≤ 0 and for a degree > max_near_degree.
PHRAME_API std::variant<NearCurve, NotNear> near_curve(const Vector<Polynomial>& hodograph,
                                                       const Vector<Rational>& start,
                                                       const Rational& epsilon);

/// An ε with which near_curve() would succeed.
struct NearSuggestion {
  Rational epsilon;   ///< a power of ten
  Rational distance;  ///< ≤ epsilon: a bound of the distance of the curve before it is rounded
};
/// No value where no PH curve is found within a 1000th of the curve's size, nor for degrees above
/// 45, for which the search takes long.
PHRAME_API std::optional<NearSuggestion> near_suggestion(const Vector<Polynomial>& hodograph,
                                                         const Vector<Rational>& start);

/// An exact PH spline near several polynomial curves, each on its own [0, 1].
struct NearPath {
  PhPath path;        ///< exact
  Nearness nearness;  ///< to what was given
};

/// The same for one or more curves that follow one another, each given by its control points. At
/// its joints the spline has exactly one position and one tangent, and also one derivative where
/// the derivatives given agree within what ε allows. Each segment starts where the one before ends,
/// and aims at the points given, so that distances do not add up. The spline of a closed path need
/// not close exactly. Throws DomainError as near_curve() does, and where the tangent of those
/// curves breaks or is undefined, at a cusp, at a joint. Tangents at joints are found in doubles,
/// so that ε should be at least 1e-15 of the size.
PHRAME_API std::variant<NearPath, NotNear> near_path(
    const std::vector<std::vector<Vector<Rational>>>& curves, const Rational& epsilon);
/// The same of a path of polynomial curves. Throws DomainError for others, too.
PHRAME_API std::variant<NearPath, NotNear> near_path(const Path& path, const Rational& epsilon);
/// The path itself where all its segments are PH, polynomial or rational; else one near it.
PHRAME_API std::variant<NamedPhPath, NotNear> near_path(const NamedPath& named,
                                                        const Rational& epsilon);

}  // namespace phrame
