#pragma once
#include "phrame/ph/curve/curve.hpp"

namespace phrame::inline v0 {

/// r′ in lowest terms: the numerators and the denominator have no common factor.
struct HodographFraction {
  Vector<Polynomial> numerator;  ///< N
  Polynomial denominator;        ///< D, D(0) = 1; 1 of a polynomial curve
};
/// r′ = N/D, which depends on the curve alone, not on how its W, A and f were chosen.
HodographFraction hodograph_fraction(const Curve& curve);
/// The same of r = X/W, W(0) ≠ 0.
HodographFraction hodograph_fraction(const Vector<Polynomial>& position, const Polynomial& weight);

}  // namespace phrame
