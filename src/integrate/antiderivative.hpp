#pragma once
#include "phrame/algebra/bivariate.hpp"
#include "phrame/algebra/rational_function.hpp"
#include "phrame/export.hpp"

namespace phrame::inline v0 {

/// Σ c(α) · log v(α, t) over the complex roots α of q.
/// ∫ dt/(t² + 1) is q = 4x² + 1, c = x, v = t + 2x.
struct LogSum {
  Polynomial index;    ///< q ∈ ℚ[x], squarefree, degree ≥ 1
  Polynomial residue;  ///< c ∈ ℚ[x], reduced modulo q, nonzero at every root
  Bivariate argument;  ///< v ∈ ℚ[x][t], degree ≥ 1, reduced modulo q; its leading coefficient is
                       ///< nonzero at every root, and 1 where deg q ≤ 2

  friend bool operator==(const LogSum&, const LogSum&) = default;
};

/// Is v = t − x, so that the sum is Σ c(z) · log(t − z) over the roots z of q themselves?
PHRAME_API bool is_over_poles(const LogSum& sum);

/// F = polynomial + rational + Σ logs, up to a constant [Bronstein 2005, §2.5].
/// Two antiderivatives differ by a constant iff their derivatives are equal.
struct Antiderivative {
  Polynomial polynomial;      ///< the polynomial part, integrated
  RationalFunction rational;  ///< proper
  std::vector<LogSum> logs;   ///< none where F is rational

  friend bool operator==(const Antiderivative&, const Antiderivative&) = default;
};

/// @{ F′ ∈ ℚ(t), computed exactly in ℚ[x]/(q): no root is approximated.
PHRAME_API RationalFunction differentiate(const LogSum& sum);
PHRAME_API RationalFunction differentiate(const Antiderivative& F);
/// @}

/// F(b) − F(a) without the logarithms. Throws DomainError where that has a pole at an end.
PHRAME_API Rational difference_without_logarithms(const Antiderivative& F, const Rational& a,
                                                  const Rational& b);

}  // namespace phrame
