#pragma once
#include "phrame/algebra/rounding.hpp"
#include "phrame/export.hpp"
#include "phrame/integrate/antiderivative.hpp"
#include "phrame/integrate/endpoint.hpp"
#include "phrame/integrate/exact_value.hpp"

namespace phrame::inline v0 {

/// The value of a definite integral.
struct DefiniteIntegral {
  Real value;  ///< exact where it is rational
  /// In finite terms, where the ends are rational or infinite and all residues lie in ℚ(i) or
  /// belong to turned_logs(); at algebraic ends a rational number plus a rational multiple of π.
  std::optional<ExactValue> exact;
};

/// What is done with poles between the ends.
enum class AtPoles {
  refuse,           ///< no integral has a pole on its path
  principal_value,  ///< Cauchy's: simple poles between the ends, from −∞ to ∞ the limit for R → ∞
                    ///< of the integral from −R to R
};

/// ∫ f from a to b, of any order. Throws DomainError where it does not exist, saying why: a pole
/// in [a, b], named by its isolating interval, or f too large at an infinite end.
PHRAME_API DefiniteIntegral definite_integral(const RationalFunction& f, const Endpoint& a,
                                              const Endpoint& b,
                                              AtPoles at_poles = AtPoles::refuse);

/// The same where an antiderivative F of f is known.
PHRAME_API DefiniteIntegral definite_integral(const Antiderivative& F, const RationalFunction& f,
                                              const Endpoint& a, const Endpoint& b,
                                              AtPoles at_poles);

/// The same for the derivative of F.
PHRAME_API DefiniteIntegral definite_integral(const Antiderivative& F, const Endpoint& a,
                                              const Endpoint& b,
                                              AtPoles at_poles = AtPoles::refuse);

}  // namespace phrame
