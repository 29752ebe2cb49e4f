#pragma once
#include <optional>

#include "phrame/algebra/rational_function.hpp"
#include "phrame/algebra/surd.hpp"
#include "phrame/integrate/taylor_integral.hpp"

namespace phrame::inline v0 {

/// factor·√radicand, an antiderivative of some N/(D√S).
struct AlgebraicIntegral {
  RationalFunction factor;
  Polynomial radicand;

  /// Its value where the factor has no pole and the radicand is > 0.
  Surd operator()(const Rational& t) const;
};

/// The antiderivative of N/(D√S) that is algebraic, where there is one: it is a rational multiple
/// of √S then (Liouville), and that is decided by a linear system. S is squarefree, as of
/// TaylorIntegral::integrand(). No value where there is none, or the system would have more than 40
/// unknowns.
std::optional<AlgebraicIntegral> algebraic_integral(const RootQuotient& f);

}  // namespace phrame
