#pragma once
#include <optional>

#include "phrame/export.hpp"
#include "phrame/ph/curve/path.hpp"

namespace phrame::inline v0 {

// A fixed vector v that is nowhere along the tangent gives the path a frame: e₂ = v × H/|v × H|,
// e₃ = e₁ × e₂. Almost every v does. v × H vanishes where all three components do, so at the zeros
// of their greatest common divisor: there is mostly none but a constant.

/// Where v ≠ 0 is along the tangent of a segment, or may be.
struct TangentPlace {
  Interval place;   ///< the exact place, or where it is isolated
  bool is_certain;  ///< is it, or is it not told within that?
};
/// The first such place; no value where v × H has no zero on [0, 1]. Of a rational curve it is
/// certain, of one by formulas where s is a simple fraction or multiple of π there.
PHRAME_API std::optional<TangentPlace> tangent_along(const RationalCurve& curve,
                                                     const Vector<Rational>& v);
PHRAME_API std::optional<TangentPlace> tangent_along(const ExpressionCurve& curve,
                                                     const Vector<Rational>& v);  ///< likewise
PHRAME_API std::optional<TangentPlace> tangent_along(const Segment& segment,
                                                     const Vector<Rational>& v);  ///< likewise

/// Throws DomainError where v is 0, or along the tangent somewhere: "the up vector (0, 0, 1) is
/// along the tangent at t = 1/2"; Undecided where that is not told.
PHRAME_API void require_up_vector(const Path& path, const Vector<Rational>& v);

/// Is it a straight line, by the form of its formulas where it has such? Then all its normal frames
/// that do not turn are rotation-minimizing.
PHRAME_API bool is_straight(const Path& path);
/// A vector normal to the plane of the path, of integers without a common factor; no value where it
/// is straight or in no plane, by the form of its formulas where it has such.
PHRAME_API std::optional<Vector<Rational>> plane_normal(const Path& path);

/// A v that is nowhere along the tangent, of small integers: the normal of a plane path, whose
/// frame is rotation-minimizing already; for others the one of a list whose angle to the tangent
/// stays largest, as far as few points show. Throws Undecided where the whole list does not do.
PHRAME_API Vector<Rational> up_vector(const Path& path);

}  // namespace phrame
