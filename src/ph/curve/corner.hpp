#pragma once
#include <vector>

#include "phrame/export.hpp"
#include "phrame/ph/curve/path.hpp"

namespace phrame {

/// Where the tangent of a path breaks.
struct Corner {
  std::size_t segment;  ///< at whose start it is; 0 is where the ends of a closed path meet
  Real angle;  ///< between the tangents, in [0, π), of formulas next to 0 where it may be 0
};
/// All of them, by segment; that of the ends, where they are told to be closed, is the last.
PHRAME_API std::vector<Corner> corners(const Path& path);
/// The greatest of them, of which there is one at least; where 64 bits do not tell, one of those.
PHRAME_API const Corner& greatest(const std::vector<Corner>& corners);

/// How a frame with e₁ along a and e₂ along S, carried from a to the vector b by the least rotation
/// that takes one direction to the other, is turned about b against one with e₂ along T: the angle
/// in (−π, π] from T to the image of S. Exact where it is seen to be 0, and an algebraic angle
/// where all are exact. Precondition: S is normal to a, T to b, all of any length > 0, and a is not
/// opposite to b.
PHRAME_API Real carried_angle(const Vector<Real>& a, const Vector<Real>& S, const Vector<Real>& b,
                              const Vector<Real>& T);

}  // namespace phrame
