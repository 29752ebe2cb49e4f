#pragma once
#include "phrame/io/write/angle_report.hpp"
#include "phrame/io/write/cas_formula.hpp"
#include "phrame/io/write/integral_report.hpp"

namespace phrame {

// What a computer-algebra system is given: a statement a line, which define `integrand`,
// `antiderivative` and, where ends were given, `definite`. In PARI the first two are functions.
// The antiderivative is continuous between the real poles; where a form was asked for that is not,
// a comment says so. Where PARI needs more digits than it has by default to compute the sums over
// roots, its script sees to that first.

std::string to_script(const IntegralReport& report, Language language);
/// The values of an angle are not in it.
std::string to_script(const AngleReport& report, Language language);

}  // namespace phrame
