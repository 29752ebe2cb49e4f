#pragma once
#include "phrame/algebra/ball_series.hpp"
#include "phrame/algebra/complex_series.hpp"
#include "phrame/ph/curve/formula_program.hpp"

namespace phrame::inline v0 {

/// The Taylor series of all steps around the first coefficient of the series s, the variable, to
/// `length` coefficients. Not finite where a step is undefined. Defined for BallPolynomial and
/// ComplexSeries.
template <class Series>
std::vector<Series> evaluate_steps(const std::vector<Formula::Step>& steps, const Series& s,
                                   long length, long bits);

/// The value of a constant step.
RealBall constant_value(const FormulaProgram& program, FormulaProgram::Id a, long bits);
/// The value of a constant expression; not finite where it is undefined.
RealBall constant_value(const Formula& f, long bits);

}  // namespace phrame
