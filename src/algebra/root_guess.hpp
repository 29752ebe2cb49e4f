#pragma once
#include <complex>
#include <vector>

#include "phrame/algebra/handle.hpp"

namespace phrame {

/// Approximations of all complex roots of f in double precision, by the iteration of Ehrlich and
/// Aberth. Nothing is proved about them: they save a certified root finder its first steps.
/// Empty where doubles do not reach (coefficients too far apart, no convergence).
/// Bini, Numerical computation of polynomial zeros by means of Aberth's method, Numerical
/// Algorithms 13 (1996).
std::vector<std::complex<double>> guess_roots(const flint::FmpzPoly& f);

}  // namespace phrame
