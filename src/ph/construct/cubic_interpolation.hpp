#pragma once
#include <vector>

#include "phrame/ph/construct/bezier_points.hpp"
#include "phrame/ph/curve/spline_slopes.hpp"

namespace phrame::inline v0 {

/// Where the parameters of points come from that are given without.
enum class ParameterChoice {
  uniform,        ///< 0, 1, 2, …
  chord_lengths,  ///< sums of the distances, each rounded to 12 bits
  centripetal     ///< sums of their square roots, each rounded to 12 bits [Lee 1989]
};
/// One parameter for each point, from 0. Throws DomainError where two successive points are equal,
/// unless they are uniform.
std::vector<Rational> parameters_of(const std::vector<Vector<Rational>>& points,
                                    ParameterChoice choice);

/// What a C² cubic spline is to pass.
struct CubicInterpolation {
  std::vector<Vector<Rational>> points;    ///< two at least; periodic: three, the last is the first
  std::vector<Rational> parameters;        ///< increasing, one for each
  SplineEnds ends = SplineEnds::natural;   ///< what is said of them
  Vector<Rational> start_derivative = {};  ///< with respect to the parameter; of clamped ones
  Vector<Rational> end_derivative = {};    ///< the same at the end
};

/// Up to so many points the spline is exact; the end of a closed one is none more.
inline constexpr std::size_t exact_cubic_points = 50;

/// The derivatives of the C² cubic spline at its points: for exact_cubic_points at most in ℚ, where
/// their digits are as many as those of all points together. For more they are rounded to multiples
/// of 2^−k, at least 128 bits below the greatest: the spline passes the points and is C¹, has r″ =
/// 0 at natural ends, and stays in the line or plane of its points, all that exactly; only its
/// second derivatives are off at the joints. Throws DomainError for parameters that do not
/// increase, wrong counts, and a periodic spline that does not end where it starts.
std::vector<Vector<Rational>> cubic_derivatives(const CubicInterpolation& data);

/// No coordinate of one of these derivatives is off by more: 0 where the spline is C² exactly. It
/// is the residual: the equations' matrix, with rows divided by hₖ₋₁ + hₖ, has 2 on its diagonal
/// and 1 beside it, so that its inverse is at most 1.
Rational error_of_derivatives(const CubicInterpolation& data,
                              const std::vector<Vector<Rational>>& derivatives);

/// The cubic between the points k and k + 1 as a Bézier curve, with four control points, for
/// derivatives as cubic_derivatives() finds them.
BezierPoints cubic_piece(const CubicInterpolation& data,
                         const std::vector<Vector<Rational>>& derivatives, std::size_t k);

}  // namespace phrame
