#pragma once
#include "phrame/answer/angle.hpp"
#include "phrame/answer/integral.hpp"
#include "phrame/io/write/cas_formula.hpp"

namespace phrame::inline v0 {

/// What a computer-algebra system is given: a statement a line, which define `integrand`,
/// `antiderivative` and, where ends were given, `definite`. In PARI the first two are functions.
/// The antiderivative is continuous between the real poles; where a form was asked for that is not,
/// a comment says so. Where PARI needs more digits than it has by default to compute the sums over
/// roots, its script sees to that first.
std::string to_script(const IntegralAnswer& answer, Language language);
/// The same of an angle, whose values are not in it. Precondition: the path is a curve.
std::string to_script(const AngleAnswer& answer, Language language);

}  // namespace phrame
