#pragma once
#include <array>

#include "phrame/algebra/gaussian_integer.hpp"
#include "phrame/ph/curve/quaternion.hpp"

namespace phrame {

/// The Bernstein coefficients of A, quadratic, on [0, 1].
using QuadraticPreimage = std::array<RationalQuaternion, 3>;

/// The halves [0, 1/2] and [1/2, 1] of A, each on [0, 1], their middle coefficients moved by about
/// 2^−bits, such that the mean of the two ∫ A i A* is `integral`, exactly; the values of A at 0,
/// 1/2 and 1 stay. The integral is wanted near that of A. In the plane z = 0 the halves stay there.
/// Throws Undecided where no such numbers were found, as of straight pieces.
std::array<QuadraticPreimage, 2> exact_halves(const QuadraticPreimage& a,
                                              const Vector<Rational>& integral, long bits);

/// A number of size 1 in ℚ(i), within about 2^−bits of z/|z|; 1 for 0.
GaussianRational unit_near(const GaussianRational& z, long bits);

}  // namespace phrame
