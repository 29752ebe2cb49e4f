#pragma once
#include "phrame/algebra/real_algebraic.hpp"
#include "phrame/export.hpp"
#include "phrame/ph/curve/segment.hpp"

namespace phrame::inline v0 {

/// Where r′ = 0: the real roots of f and of gcd(u, v, p, q) in the interval, with their order in
/// |r′| = |f|·σ. None on a regular curve.
PHRAME_API std::vector<RealRoot> cusps(const Curve& curve,
                                       const Interval& interval = closed_interval(0, 1));

/// The same on a segment of any kind: where p = 0 along a RationalCurve; formulas have none.
PHRAME_API std::vector<RealRoot> cusps(const Segment& segment);

/// Where the tangent stands still: the real zeros of g in the interval, those apart that only a
/// real factor of A brings. (n, b) flip at those of odd order. None for a straight line.
PHRAME_API std::vector<RealRoot> inflections(const QuaternionPolynomial& a,
                                             const Interval& interval = closed_interval(0, 1));

/// Those of odd order, where what vanishes changes its sign.
PHRAME_API std::vector<RealRoot> odd(const std::vector<RealRoot>& points);
/// Those of them in (0, 1).
PHRAME_API std::vector<RealRoot> odd_inside(const std::vector<RealRoot>& points);
/// Where in (0, 1) a polynomial that is not 0 changes its sign, as f or p does where a curve turns
/// back.
PHRAME_API std::vector<RealAlgebraic> sign_changes(const Polynomial& p);
/// Its sign in (0, 1), but for zeros; 0 where it changes: for f or p the sign of r′·e₁.
PHRAME_API int constant_sign(const Polynomial& p);

}  // namespace phrame
