#pragma once
#include <vector>

#include "phrame/algebra/ball.hpp"

namespace phrame {

/// Approximations of all complex roots of f ≠ 0, exact balls with numbers of double precision, by
/// the iteration of Ehrlich and Aberth, each as far as doubles go. Nothing is proved about them:
/// they save a certified root finder its first steps. Bini, Numerical computation of polynomial
/// zeros by means of Aberth's method, Numerical Algorithms 13 (1996).
std::vector<ComplexBall> guess_roots(const flint::FmpzPoly& f);

}  // namespace phrame
