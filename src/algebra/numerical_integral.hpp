#pragma once
#include <functional>

#include "phrame/algebra/ball.hpp"

namespace phrame::inline v0 {

/// Encloses f(z): for a ball z around which f is not analytic, an infinite ball.
using AnalyticFunction = std::function<ComplexBall(const ComplexBall& z, long bits)>;

/// How far numerical_integral() goes.
struct IntegralEffort {
  long bits;         ///< of the result: a radius of about 2^−bits is aimed at
  long precision;    ///< that f is asked for
  long most_points;  ///< values of f
};

/// A ball around ∫ₐᵇ f for an f that is real on [a, b], of whatever width is reached. By Gauss's
/// and Legendre's rule on parts, with errors from enclosures of f on discs far from the path: f
/// must give narrow ones [Johansson 2018].
RealBall numerical_integral(const AnalyticFunction& f, const RealBall& a, const RealBall& b,
                            const IntegralEffort& effort);

/// The principal √z in an integrand: not finite where the ball meets (−∞, 0], across which it is
/// not analytic.
ComplexBall integrand_sqrt(const ComplexBall& z, long bits);

}  // namespace phrame
