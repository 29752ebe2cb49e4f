#pragma once
#include <array>
#include <vector>

#include "phrame/ph/curve/path.hpp"

namespace phrame::inline v0 {

/// The control points (x, y) of a cubic Bézier curve.
using PlaneCubic = std::array<std::array<Rational, 2>, 4>;

/// Cubics, one after the other, for a path of PH and rational curves in a plane z = const: each is
/// within `tolerance` of a part of it, at the same share of its parameter, which is proved. Control
/// points have finitely many decimals, and a cubic begins where the one before ends. Throws
/// DomainError for a segment by formulas.
std::vector<PlaneCubic> plane_cubics(const Path& path, const Rational& tolerance);

/// One of them, and the part of the curve that it is for.
struct CubicPart {
  PlaneCubic cubic;
  Rational from;  ///< its parameter
  Rational to;    ///< likewise, greater
};
/// The same for a part of a curve. Precondition: 0 ≤ from < to ≤ 1.
std::vector<CubicPart> plane_cubics(const RationalCurve& curve, const Rational& from,
                                    const Rational& to, const Rational& tolerance);

}  // namespace phrame
