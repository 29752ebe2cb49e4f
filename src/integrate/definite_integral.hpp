#pragma once
#include "phrame/algebra/rounding.hpp"
#include "phrame/integrate/antiderivative.hpp"
#include "phrame/integrate/endpoint.hpp"

namespace phrame {

/// rational + pi·π + Σ factor·log(of) + Σ factor·arctan(of), every `of` > 0 and ≠ 1.
struct ExactValue {
  struct Term {
    Rational factor;
    Rational of;
    friend bool operator==(const Term&, const Term&) = default;
  };
  Rational rational;
  Rational pi;
  std::vector<Term> logarithms;
  std::vector<Term> arctangents;
  friend bool operator==(const ExactValue&, const ExactValue&) = default;
};

struct DefiniteIntegral {
  Real value;  ///< exact where it is rational
  /// In finite terms, where the ends are rational or infinite and all residues lie in ℚ(i).
  std::optional<ExactValue> exact;
};

enum class AtPoles {
  refuse,          ///< a pole on the path has no integral
  principal_value  ///< Cauchy's, where it exists: at simple poles between the ends
};

/// ∫ f from a to b, of any order. Throws DomainError where it does not exist, saying why: a pole
/// in [a, b], named by its isolating interval, or f too large at an infinite end.
DefiniteIntegral definite_integral(const RationalFunction& f, const Endpoint& a, const Endpoint& b,
                                   AtPoles at_poles = AtPoles::refuse);

/// The same for the derivative of F.
DefiniteIntegral definite_integral(const Antiderivative& F, const Endpoint& a, const Endpoint& b,
                                   AtPoles at_poles = AtPoles::refuse);

}  // namespace phrame
