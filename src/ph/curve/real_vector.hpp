#pragma once
#include <vector>

#include "phrame/algebra/algebraic_angle.hpp"
#include "phrame/ph/curve/quaternion.hpp"

namespace phrame::inline v0 {

// Vectors of real numbers: what can be exact is.

/// The same numbers.
Vector<Real> as_reals(const Vector<Rational>& v);

/// The same numbers, where all are known exactly.
std::optional<Vector<Rational>> exactly(const Vector<Real>& v);
/// The same numbers, and of those that are not exact rational ones within about 2^−256 of them.
Vector<Rational> near(const Vector<Real>& v);

/// u × v, exact where both are.
Vector<Real> cross(const Vector<Real>& u, const Vector<Real>& v);

/// −v
Vector<Real> opposite(const Vector<Real>& v);

/// a/b, b ≠ 0: exact where both are.
Real quotient_of(const Real& a, const Real& b);
/// x/√s, s > 0: where both are exact, exact if it is rational, else irrational.
Real over_square_root(const Real& x, const Real& s);

/// The sum, exact where all terms are. Thousands of terms cost as many times one.
Real sum_of(std::vector<Real> terms);

/// The sign of x; 0 also where 2048 bits do not tell it from 0.
int sign_of(const Real& x);

/// arg(x + iy) in (−π, π], or next to π where it is not told from that. Exact where y = 0 < x; the
/// algebraic angle that it is, up to whole turns, may be given, and else is known on the axes.
Real argument_of(const Real& x, const Real& y,
                 std::function<std::optional<AlgebraicAngle>()> known = {});

/// Is it known to be exactly 0?
bool is_zero(const Vector<Real>& v);

}  // namespace phrame
