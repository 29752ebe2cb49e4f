#pragma once
#include <optional>

#include "phrame/ph/smooth/smooth_path.hpp"

namespace phrame {

// A fixed vector v that is nowhere along the tangent gives the path a frame: e₂ = v × H/|v × H|,
// e₃ = e₁ × e₂. Almost every v does. v × H vanishes where all three components do, so at the zeros
// of their greatest common divisor: there is mostly none but a constant.

/// Where v ≠ 0 is first along the tangent of the curve, exactly or isolated; no value where v × H
/// has no zero on [0, 1].
std::optional<Interval> tangent_along(const RationalCurve& curve, const Vector<Rational>& v);

/// Throws DomainError where v is 0, or along the tangent somewhere: "the up vector (0, 0, 1) is
/// along the tangent at t = 1/2".
void require_up_vector(const SmoothPath& path, const Vector<Rational>& v);

/// Is it a straight line? Then all its normal frames that do not turn are rotation-minimizing.
bool is_straight(const SmoothPath& path);
/// A vector normal to the plane of the path, of integers without a common factor; no value where it
/// is straight or in no plane.
std::optional<Vector<Rational>> plane_normal(const SmoothPath& path);

/// A v that is nowhere along the tangent, of small integers: the normal of a plane path, whose
/// frame is rotation-minimizing already; for others the one of a list whose angle to the tangent
/// stays largest, as far as few points show. Throws Undecided where the whole list does not do.
Vector<Rational> up_vector(const SmoothPath& path);

}  // namespace phrame
