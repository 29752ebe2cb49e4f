#pragma once
#include "phrame/algebra/factor.hpp"

namespace phrame::inline v0 {

/// factor(p) for p = divisor·(a polynomial coprime to it): two factorizations of lower degrees take
/// less time than one.
Factorization factor(const Polynomial& p, const Polynomial& divisor);

}  // namespace phrame
