#pragma once
#include <optional>

#include "phrame/algebra/polynomial.hpp"

namespace phrame {

/// The numbers x_k with Σ x_k · columns[k] = right side, as an identity of the coefficients of
/// t⁰, …, t^{equations−1}. No value where the system is not square or is singular.
/// Precondition: every degree < equations.
std::optional<std::vector<Rational>> solve_for_coefficients(const std::vector<Polynomial>& columns,
                                                            const Polynomial& right_side,
                                                            long equations);

}  // namespace phrame
