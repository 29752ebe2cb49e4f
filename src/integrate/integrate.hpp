#pragma once
#include "phrame/export.hpp"
#include "phrame/integrate/antiderivative.hpp"

namespace phrame::inline v0 {

/// How the logarithms are written.
enum class Form {
  automatic,          ///< the smallest field: over the poles where the residues are distinct, else
                      ///< over the residues
  partial_fractions,  ///< over the poles: one logarithm for each
  rothstein_trager,   ///< over the residues, by gcds, one sum for each irreducible polynomial of
                      ///< them
  lazard_rioboo_trager,  ///< over the residues, nothing factored, one sum for each number of poles
};

/// f = F′ + rest, F without logarithms; rest is proper and has a squarefree denominator, so that
/// the integral of f is F and logarithms.
struct AlgebraicPart {
  Antiderivative F;       ///< a polynomial and a proper fraction
  RationalFunction rest;  ///< of which the integral is logarithms only
};

/// By division and Hermite's reduction: nothing is factored, and no form of the logarithms chosen.
PHRAME_API AlgebraicPart algebraic_part(const RationalFunction& f);

/// ∫ f dt for any f ∈ ℚ(t). The polynomial part by division, the rational part by Hermite's
/// reduction, the logarithms in the form asked for. The result is checked before it is returned:
/// differentiate(result) == f.
/// Cost: dominated by the factorization of the denominator and a modular inverse of its degree.
PHRAME_API Antiderivative integrate(const RationalFunction& f, Form form = Form::automatic);

}  // namespace phrame
