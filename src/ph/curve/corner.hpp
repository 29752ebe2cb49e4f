#pragma once
#include <vector>

#include "phrame/export.hpp"
#include "phrame/ph/curve/path.hpp"

namespace phrame::inline v0 {

/// A corner: a joint where the tangent of a path breaks.
struct Corner {
  std::size_t segment;  ///< at whose start it is; 0 is where the ends of a closed path meet
  Real angle;  ///< between the tangents, in [0, π), of formulas next to 0 where it may be 0
};
/// All corners, by segment. The one where the ends of a closed path meet, if they are told to meet,
/// is the last.
PHRAME_API std::vector<Corner> corners(const Path& path);
/// The greatest of the corners, at least one. Where 64 bits do not tell which that is, it is one of
/// those that may be.
PHRAME_API const Corner& greatest(const std::vector<Corner>& corners);

/// A frame with e₁ along a and e₂ along S is carried from a to b by the least rotation that takes
/// the direction of a to that of b. The angle in (−π, π] about b from T to where S is carried.
/// Exact where it is seen to be 0, and an algebraic angle where all vectors are exact.
/// Precondition: S is normal to a, T to b, all of any length > 0, and a is not opposite to b.
PHRAME_API Real carried_angle(const Vector<Real>& a, const Vector<Real>& S, const Vector<Real>& b,
                              const Vector<Real>& T);

}  // namespace phrame
