#pragma once
#include <optional>
#include <vector>

#include "phrame/algebra/ball.hpp"

namespace phrame::inline v0 {

/// A factor of a denominator.
struct PolePower {
  Polynomial base;
  long exponent;  ///< ≥ 1
};

/// By how much the integral of f changes from 0 to 1 but for its logarithms, to about so many bits:
/// what hermite_reduce() and the polynomial part of f give exactly, in a tenth of the time. No
/// value where the product of the powers is not the denominator of f but for a constant, where a
/// base has a zero in common with another one or a multiple zero, and where poles are too close to
/// each other. Precondition: f has no pole at 0 and 1.
std::optional<RealBall> rational_change(const RationalFunction& f,
                                        const std::vector<PolePower>& denominator, long bits);

}  // namespace phrame
