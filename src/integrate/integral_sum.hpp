#pragma once
#include "phrame/integrate/definite_integral.hpp"

namespace phrame::inline v0 {

/// factor · ∫ f from `from` to `to`, where F is an antiderivative of f without a pole between them.
struct IntegralPart {
  RationalFunction f;   ///< the integrand
  Antiderivative F;     ///< with F′ = f
  Rational from = 0;    ///< where the path begins
  Rational to = 1;      ///< and ends
  Rational factor = 1;  ///< of the integral
};

/// Integrals that are added up, and their value as far as it is known.
struct KnownIntegral {
  DefiniteIntegral value;  ///< as far as it is known
  /// Whose sum it is. They may be left out where it is rational, and where they are not between
  /// rational ends: it then takes part in what is known in finite terms only.
  std::vector<IntegralPart> parts = {};
};

/// The sum. Its value is exact where it is seen to be rational, also where what is irrational of
/// different integrals cancels, in the manner of definite_integral(): decided where all are known
/// in finite terms, and recognised in many other cases. In finite terms where all are, and no two
/// of them have an irrational multiple of π.
DefiniteIntegral sum_of_integrals(const std::vector<KnownIntegral>& integrals);

}  // namespace phrame
