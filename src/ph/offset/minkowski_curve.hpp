#pragma once
#include <variant>
#include <vector>

#include "phrame/export.hpp"
#include "phrame/ph/curve/quaternion.hpp"

namespace phrame::inline v0 {

/// A plane curve with radii, r = (x, y, r), of which x′² + y′² − r′² = σ² is the square of a
/// polynomial (Minkowski Pythagorean-hodograph) [Moon 1999]:
///   x′ = f(u² + v² − p² − q²), y′ = 2f(up − vq), r′ = 2f(uv − pq), σ = f(u² − v² + p² − q²),
/// in lowest terms: what f is multiplied by have no common factor, f > 0 for small t > 0, and so
/// is σ.
struct MinkowskiCurve {
  QuaternionPolynomial preimage;  ///< u, v, p, q
  Polynomial multiplier;          ///< f, primitive up to its sign
  Vector<Rational> start;         ///< the center and the radius at t = 0
};

/// (x, y, r)′/f.
PHRAME_API Vector<Polynomial> direction(const MinkowskiCurve& curve);
/// σ/f = u² − v² + p² − q².
PHRAME_API Polynomial spacelike_root(const MinkowskiCurve& curve);
/// (x, y, r), of t.
PHRAME_API Vector<Polynomial> position(const MinkowskiCurve& curve);

/// a = u + v + p + q, b = u − v − p + q, c = u + v − p − q, d = u − v + p − q:
///   x′ + r′ = f·ac, x′ − r′ = f·bd, σ + y′ = f·ad, σ − y′ = f·bc.
PHRAME_API std::vector<Polynomial> null_factors(const MinkowskiCurve& curve);

/// Why a curve with radii is none: x′² + y′² − r′² is `number` · `odd_factor` · (a square in ℚ[t]),
/// and not 1·1·(a square), or it is 0, and then `number` is.
struct NotMinkowski {
  Integer number;         ///< without the square factors that are found
  Polynomial odd_factor;  ///< squarefree, primitive
};
/// One line: why not.
PHRAME_API std::string to_string(const NotMinkowski& reason);

/// The curve with this hodograph (x, y, r)′, checked exactly, or why there is none. Up to σ → −σ
/// all solutions over ℚ[t] are this one, with squares that divide f taken into a, b or into c, d,
/// and with a, b multiplied and c, d divided by a constant. Throws DomainError where all of it is
/// 0.
PHRAME_API std::variant<MinkowskiCurve, NotMinkowski> identify_minkowski(
    const Vector<Polynomial>& hodograph, const Vector<Rational>& start);

}  // namespace phrame
