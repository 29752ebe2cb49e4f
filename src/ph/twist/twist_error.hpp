#pragma once
#include <memory>

#include "phrame/ph/twist/rotation_family.hpp"

namespace phrame::inline v0 {

// How far a piece's frame, turned by a rational rotation w, is from one that turns at the constant
// rate; proved. Per unit of τ it turns by
//   erf_rate + θ′ = M/(dD),  M = nD + 2d(ab′ − a′b),  D = |w|², erf_rate = n/d,
// and E = (erf_rate + θ′)/speed − T is Ω₁ − Ω̄₁ where the piece's length is the unit.
// w must have no zero on [0, 1]. All are given to about `bits` bits, where w is known to
// working_precision() bits.

/// M: it changes its sign at the inflections of the frame, where Ω₁ does.
BallPolynomial turn_numerator(const TwistPiece& piece, const Rotation& w, long bits);

/// G = ∫₀¹ E²·speed dτ (36). √G/|T| is the relative root mean square of Ω₁ − Ω̄₁.
RealBall mean_square(const TwistPiece& piece, const Rotation& w, long bits);

/// √G for w = a + ib over ℚ.
Real root_mean_square(const TwistPiece& piece, const Polynomial& a, const Polynomial& b);

/// dG/dp of a family with one parameter p.
RealBall mean_square_slope(const TwistPiece& piece, const RotationFamily& family,
                           const Rational& parameter, long bits);

/// d²G/dp² on intervals of the parameter. What does not depend on it is evaluated once for all
/// calls, whose quadratures meet the same points again and again. Not for concurrent use.
class MeanSquareConvexity {
 public:
  /// Best near a centre, a parameter.
  MeanSquareConvexity(const TwistPiece& piece, const RotationFamily& family, const Rational& centre,
                      long bits);
  ~MeanSquareConvexity();
  MeanSquareConvexity(const MeanSquareConvexity&) = delete;
  MeanSquareConvexity& operator=(const MeanSquareConvexity&) = delete;

  /// At all numbers of the ball; as narrow as so many values of the integrand make it.
  RealBall operator()(const RealBall& parameter, long most_points);

 private:
  class Points;
  std::unique_ptr<Points> points_;
  long bits_;
  long more_;
};

/// The maximum of |E| on [0, 1].
RealBall greatest_error(const TwistPiece& piece, const Rotation& w, long bits);

/// The precision for the w of a piece whose results are to have so many bits.
long working_precision(const TwistPiece& piece, long bits);

}  // namespace phrame
