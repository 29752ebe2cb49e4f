#pragma once
#include "phrame/integrate/antiderivative.hpp"

namespace phrame {

/// How the logarithms are written.
enum class Form {
  automatic,  ///< partial fractions where the residues are distinct, else Rothstein–Trager
  partial_fractions,  ///< one logarithm for each pole
  rothstein_trager,   ///< one logarithm for each residue
};

/// ∫ f dt for any f ∈ ℚ(t). The polynomial part by division, the rational part by Hermite's
/// reduction, the logarithms in the form asked for, one sum for each irreducible factor of the
/// denominator (sums with equal residues joined in Rothstein–Trager's form). The result is checked
/// before it is returned: differentiate(result) == f.
/// Cost: dominated by the factorization of the denominator and a modular inverse of its degree.
Antiderivative integrate(const RationalFunction& f, Form form = Form::automatic);

}  // namespace phrame
