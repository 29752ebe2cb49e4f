#pragma once
#include <array>
#include <optional>

#include "phrame/algebra/ball_polynomial.hpp"
#include "phrame/ph/twist/wronskian_planes.hpp"

namespace phrame::inline v0 {

// The best pair in a plane. All bases of it with the same determinant as a, b have
//   a²+b² ↦ D = x₁a² + 2x₂ab + x₃b²,  x₁x₃ − x₂² = 1,  x₁ > 0,
// so that J = ∫₀¹ ρ(D − s)² = xᵀQx − 2cᵀx + J₀ with a positive definite Q. Its critical points are
//   (Q − λK)x = c,  xᵀKx = x₁x₃ − x₂² = 1:  the roots λ of a polynomial of degree 6.
//
// At the least one Q − λK is positive definite, and where it is, x is the least one: with L = J −
// λ(xᵀKx − 1), which is convex then, J(y) = L(y) ≥ L(x) = J(x) for all y with yᵀKy = 1. On the set
// of such λ, an interval around 0, xᵀKx increases, so that there is one such λ at most.

/// A basis a, b in powers of t.
struct PlaneBasis {
  BallPolynomial a;  ///< a
  BallPolynomial b;  ///< b
};
/// That in normal form.
PlaneBasis enclose(const WronskianPlane& plane, const Rational& origin, long bits);

/// A critical point of J.
struct CriticalPair {
  RealBall multiplier;           ///< λ
  std::array<RealBall, 3> form;  ///< x
  RealBall value;                ///< J
};

/// What is known of those in a plane.
struct PlanePairs {
  CriticalPair best;                             ///< with the least J of all in the plane: proved
  std::optional<std::vector<CriticalPair>> all;  ///< by ascending λ, where they could be told apart
};

/// For s > 0 on (0, 1), and balls around ∫₀¹ ρtᵏ for k up to the degrees of D², Ds and s². No value
/// where the balls are too wide to prove it, or where two pairs are equally good.
std::optional<PlanePairs> best_in_plane(const PlaneBasis& basis, const Polynomial& s,
                                        const std::vector<RealBall>& moments, long bits);

}  // namespace phrame
