#pragma once
#include "phrame/ph/curve/path.hpp"

namespace phrame::inline v0 {

/// PH curves that have at each t the e₁ of the path, one after the other from the origin. With the
/// tangent they share every frame that is carried by it alone, so the rotation-minimizing one, and
/// not lengths. All lines, arcs and others are of this kind whose unit tangent is a rational
/// function over ℚ. Throws DomainError where that of a segment is not, with the reason. Corners of
/// the path are those of what is returned.
PhPath path_with_tangents(const Path& path);

}  // namespace phrame
