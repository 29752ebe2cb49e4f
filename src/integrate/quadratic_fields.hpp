#pragma once
#include <optional>

#include "phrame/algebra/surd.hpp"
#include "phrame/integrate/partial_fractions.hpp"

namespace phrame {

/// n/d over a real quadratic field ℚ(√D): it stands for n/d + its conjugate, where √D is −√D.
struct ConjugateFractions {
  SurdPolynomial numerator;    ///< of degree ≤ 1
  SurdPolynomial denominator;  ///< t² + pt + q
};

/// A simple fraction with four poles as the sum of two conjugate fractions with two each, where its
/// denominator is reducible over a real quadratic field; no value where it is not. Of several
/// fields the one is taken over which the poles are written with the simplest roots.
/// Precondition: the denominator has degree 4.
std::optional<ConjugateFractions> over_real_quadratic_field(const SimpleFraction& f);

}  // namespace phrame
