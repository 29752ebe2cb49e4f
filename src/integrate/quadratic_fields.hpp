#pragma once
#include "phrame/algebra/surd.hpp"
#include "phrame/integrate/partial_fractions.hpp"

namespace phrame::inline v0 {

/// (αt + β)/(t² + pt + q).
struct QuadraticFraction {
  Surd alpha;
  Surd beta;
  Surd p;
  Surd q;
};

/// A simple fraction with four or eight poles as the sum of conjugate fractions with two each,
/// where its denominator is the product of two conjugate quadratic polynomials over a real
/// quadratic field, or of four over a real biquadratic one, ℚ(√d, √e); empty where it is not. Of
/// several fields the one is taken over which the poles are written with the simplest roots.
std::vector<QuadraticFraction> over_real_quadratic_fields(const SimpleFraction& f);

}  // namespace phrame
