#pragma once
#include <complex>
#include <vector>

#include "phrame/algebra/ball.hpp"

namespace phrame::inline v0 {

struct RootGuess {
  std::vector<ComplexBall> points;  ///< exact
  long vague = 0;                   ///< so many of them have fewer than about five digits
};

/// Approximations of all complex roots of f ≠ 0 with numbers of double precision, by the iteration
/// of Ehrlich and Aberth, each as far as doubles go. Nothing is proved about them: they save a
/// certified root finder its first steps. Bini, Numerical computation of polynomial zeros by means
/// of Aberth's method, Numerical Algorithms 13 (1996).
RootGuess guess_roots(const flint::FmpzPoly& f);
/// The same of f₀ + f₁t + …, all finite; none of f = 0. Sizes are cut at 2^±400.
std::vector<std::complex<double>> guess_roots(std::vector<double> f);

}  // namespace phrame
