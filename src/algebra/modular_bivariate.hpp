#pragma once
#include <optional>
#include <vector>

#include "phrame/algebra/modular.hpp"

namespace phrame {

/// Polynomials in t over 𝔽ₚ[x]/(q): the coefficients of t⁰, t¹, …, reduced modulo q, the last one
/// not 0.
using ModularBivariate = std::vector<ModularPolynomial>;

/// Without the zeros at its end.
void normalize(ModularBivariate& f);

/// The monic gcd of a and b, not both 0, by Euclid's algorithm as if 𝔽ₚ[x]/(q) were a field; no
/// value where it meets a zero divisor.
std::optional<ModularBivariate> monic_gcd(ModularBivariate a, ModularBivariate b,
                                          const ModularPolynomial& q);

}  // namespace phrame
