#pragma once
#include <array>

#include "phrame/algebra/gaussian_integer.hpp"
#include "phrame/ph/curve/quaternion.hpp"

namespace phrame::inline v0 {

/// The Bernstein coefficients of A, quadratic, on [0, 1].
using QuadraticPreimage = std::array<RationalQuaternion, 3>;

/// Two quaternions.
struct QuaternionPair {
  RationalQuaternion x;
  RationalQuaternion y;
};

/// Two with X i X* + Y i Y* = c, exactly, moved by about 2^−bits from two for which that is nearly
/// so. Of u + qk, and with c in the plane z = 0, they are such numbers. Throws Undecided where
/// none were found, as where X i X* and Y i Y* are nearly parallel.
QuaternionPair exact_pair(const QuaternionPair& near, const Vector<Rational>& c, long bits);

/// The halves [0, 1/2] and [1/2, 1] of A, each on [0, 1], their middle coefficients moved by about
/// 2^−bits, such that the mean of the two ∫ A i A* is `integral`, exactly; the values of A at 0,
/// 1/2 and 1 stay. The integral is wanted near that of A. In the plane z = 0 the halves stay there.
/// Throws Undecided where no such numbers were found, as of straight pieces.
std::array<QuadraticPreimage, 2> exact_halves(const QuadraticPreimage& a,
                                              const Vector<Rational>& integral, long bits);

/// A number of size 1 in ℚ(i), within about 2^−bits of z/|z|; 1 for 0.
GaussianRational unit_near(const GaussianRational& z, long bits);

/// The sixths of A, each on [0, 1], likewise moved such that the mean of their ∫ A i A* is
/// `integral`. A and A′ stay at both ends and are continuous between.
std::array<QuadraticPreimage, 6> exact_sixths(const QuadraticPreimage& a,
                                              const Vector<Rational>& integral, long bits);

/// The Bernstein coefficients of A, of degree 4, on [0, 1].
using QuarticPreimage = std::array<RationalQuaternion, 5>;

/// ∫ A i A* = (2/35)·X i X* + rest, X = A₂ + shift, where shift and rest have nothing of A₂.
struct QuarticSquare {
  RationalQuaternion shift;
  Vector<Rational> rest;
};
QuarticSquare complete_square(const QuarticPreimage& a);
/// ∫ A i A*.
Vector<Rational> integral(const QuarticPreimage& a);

/// The halves of A, each on [0, 1], likewise moved such that the mean of their ∫ A i A* is
/// `integral`. A and A′ stay at 0, 1/2 and 1.
std::array<QuarticPreimage, 2> exact_halves(const QuarticPreimage& a,
                                            const Vector<Rational>& integral, long bits);

}  // namespace phrame
