#pragma once
#include <vector>

#include "phrame/algebra/real.hpp"
#include "phrame/algebra/real_algebraic.hpp"
#include "phrame/export.hpp"
#include "phrame/ph/curve/path.hpp"

namespace phrame::inline v0 {

// How a curve in any plane turns, to the left where it turns counter-clockwise seen from the side
// of a normal n of the plane whose last component that is not 0 (z, else y, else x) is positive.

/// That normal, of integers without a common factor; no value for a path in no plane and on a line.
PHRAME_API std::optional<Vector<Rational>> upper_normal(const Path& path);

/// Where the signed curvature κ = n·(r′ × r″)/(|n||r′|³) of a segment is 0 or has an extremum.
struct CurvaturePlace {
  /// What is there.
  enum class Kind {
    inflection,  ///< κ changes its sign
    greatest,    ///< κ is greater than on both sides: bent most to the left, or least to the right
    least,       ///< κ is less than on both sides
  };
  RealAlgebraic t;  ///< in (0, 1)
  Kind kind;        ///< what is there
  Real curvature;   ///< κ there
};
/// All such places of a polynomial or rational curve in a plane, ascending, decided by Sturm's
/// theorem; none where κ is constant. Cusps, where κ is infinite, are none of them. Precondition:
/// the segment is such a curve in the plane with the normal. Cost: the roots of κ′.
PHRAME_API std::vector<CurvaturePlace> curvature_places(const Segment& segment,
                                                        const Vector<Rational>& normal);

/// ∫ κ ds/2π with the signed curvature: by how many turns e₁ turns to the left, with the angle in
/// (−π, π) at each corner, also that where a closed path ends. Whole for a closed path, 1 or −1
/// where that does not cross itself (Hopf's theorem), exactly; of an open path it is exact where it
/// is rational. e₁ goes on through cusps, where the tangent turns back. No value for a path in no
/// plane. Throws Undecided where formulas do not tell how the tangent turns within parts of 2^−40,
/// or whether the path is closed.
PHRAME_API std::optional<Real> rotation_index(const Path& path);

}  // namespace phrame
