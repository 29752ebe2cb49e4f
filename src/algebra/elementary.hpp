#pragma once
#include <string_view>
#include <vector>

#include "phrame/algebra/real.hpp"

namespace phrame::inline v0 {

/// The names of functions of one real number: "exp", "log", "sin", "arctan", …, as NumPy has them.
std::vector<std::string_view> elementary_functions();

/// The function of this name at x. Where x is algebraic, the value is exact where it is rational,
/// and else known to be irrational, by Lindemann's theorem. Throws DomainError for a name that is
/// none and outside of the domain, as soon as that is seen.
Real elementary(std::string_view name, const Real& x, bool is_algebraic);

/// @{ The angle of (x, y) in (−π, π], for x not 0 or y not 0; and x^y = exp(y·log x) for x > 0, and
/// 0 for x = 0 < y.
Real arctan2_of(const Real& y, const Real& x);
Real power_of(const Real& x, const Real& y);
/// @}
/// xᵏ.
Real power_of(const Real& x, long k);

}  // namespace phrame
