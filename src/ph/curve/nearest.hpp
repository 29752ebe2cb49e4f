#pragma once
#include "phrame/export.hpp"
#include "phrame/ph/curve/place.hpp"

namespace phrame::inline v0 {

/// Where something is least or greatest along a path, and what it is there.
struct PathExtreme {
  Place at;    ///< of several that are not told apart by 4096 bits the first one
  Real value;  ///< exact where that is seen to be rational
};

/// Between what values a coordinate is.
struct PathRange {
  PathExtreme least;     ///< where it is least
  PathExtreme greatest;  ///< where it is greatest
};

/// The box around a path: of x, y and z where they are least and greatest, at ends of segments and
/// at the zeros of their derivatives, which are isolated: by algebra of rational curves, and by
/// formulas by parts on which the second derivative has one sign. Throws Undecided where there are
/// none of 2^−40 or more, as where a formula stands still at its extreme to fourth order. Cost:
/// root isolation of degree n, 2n where it is rational.
PHRAME_API std::array<PathRange, 3> bounding_box(const Path& path);

/// The point of a path that is nearest to p, and its distance: of all points where r − p is across
/// r′, and of ends. Throws Undecided likewise, as along an arc around p that is given by formulas.
/// Cost: root isolation of degree 2n − 1, 3n where it is rational.
PHRAME_API PathExtreme nearest_point(const Path& path, const Vector<Rational>& p);

}  // namespace phrame
