#pragma once
#include "phrame/integrate/taylor_integral.hpp"

namespace phrame::inline v0 {

/// N/(D√S) in lowest terms, with S squarefree and D > 0 on [0, 1], as TaylorIntegral::integrand()
/// is, and with the same errors.
RootQuotient in_lowest_terms(const RootQuotient& f);

}  // namespace phrame
