#pragma once
#include <complex>
#include <vector>

#include "phrame/algebra/handle.hpp"

namespace phrame {

/// mantissa · 2^scale, the mantissa of moderate size.
struct RootGuess {
  std::complex<double> mantissa;
  long scale = 0;
};

/// Approximations of all complex roots of f ≠ 0 in double precision, by the iteration of
/// Ehrlich and Aberth. Nothing is proved about them: they save a certified root finder its first
/// steps. Empty where doubles do not reach (clusters, no convergence).
/// Bini, Numerical computation of polynomial zeros by means of Aberth's method, Numerical
/// Algorithms 13 (1996).
std::vector<RootGuess> guess_roots(const flint::FmpzPoly& f);

}  // namespace phrame
