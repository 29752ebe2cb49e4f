#pragma once
#include "phrame/export.hpp"
#include "phrame/ph/construct/near.hpp"
#include "phrame/ph/curve/path.hpp"

namespace phrame::inline v0 {

/// A path of PH curves in a plane z = const near a path in it: no point of a segment is farther
/// than ε > 0 from what stands for it, and conversely. Lines become lines, with rational unit
/// tangents, and other segments quintics, as many as are needed, that share the tangents at their
/// ends [Farouki, Neff 1995]. PH curves stay as they are, but for where they start. Corners remain;
/// one of less than a thousandth radian next to a curve that is replaced is taken for a rounding
/// and becomes smooth. A closed path remains closed, exactly: two segments are scaled a little.
/// Throws DomainError for a path in no such plane and for curves by formulas, and Undecided where ε
/// is too small for doubles to find one, some 10⁻¹² of the size, or too many quintics would be
/// needed. Cost: by (size/ε)^(1/4) quintics for each turn, which take some 50 µs each.
PHRAME_API NearPath near_plane_path(const Path& path, const Rational& epsilon);
/// The path itself where it is PH; else near_path(), of the same degrees, where there is one within
/// ε; else near_plane_path(). Throws as that.
PHRAME_API NamedPhPath near_ph_path(const NamedPath& named, const Rational& epsilon);

}  // namespace phrame
