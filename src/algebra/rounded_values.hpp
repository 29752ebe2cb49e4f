#pragma once
#include <span>

#include "phrame/algebra/near_numbers.hpp"

namespace phrame::inline v0 {

/// What polynomials of width 1 stand for at each t, correctly rounded, where they are enough for
/// that. The numbers of the others, ascending; their values are left as they are. It is computed
/// for so many t at once, which makes no difference to what it is.
/// Preconditions: from() ≤ t ≤ to(); values are as many as t, and may be t itself. In rounding to
/// nearest.
std::vector<std::size_t> rounded_values(const PiecewisePolynomial& polynomials,
                                        std::span<const double> t, std::span<double> values,
                                        std::size_t at_once = widest());
/// The same at t that need not be doubles, whose high parts are from() … to().
std::vector<std::size_t> rounded_values(const PiecewisePolynomial& polynomials,
                                        const NearNumbers& t, std::span<double> values,
                                        std::size_t at_once = widest());

}  // namespace phrame
