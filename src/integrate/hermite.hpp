#pragma once
#include "phrame/algebra/rational_function.hpp"

namespace phrame::inline v0 {

/// f = rational′ + rest, where rest has a squarefree denominator and no polynomial part: the
/// integral of f is `rational` plus logarithms only.
struct RationalPart {
  RationalFunction rational;
  RationalFunction rest;
  friend bool operator==(const RationalPart&, const RationalPart&) = default;
};

/// Hermite's reduction in Mack's form: gcds and one modular inverse a step, no factorization
/// [Bronstein 2005, §2.2]. Throws DomainError where f is not proper.
RationalPart hermite_reduce(const RationalFunction& f);

}  // namespace phrame
