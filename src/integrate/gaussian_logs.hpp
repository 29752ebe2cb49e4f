#pragma once
#include <optional>

#include "phrame/algebra/gaussian_polynomial.hpp"
#include "phrame/integrate/antiderivative.hpp"

namespace phrame::inline v0 {

/// Logarithms written with real functions as far as their residues lie in ℚ(i):
///   Σ factor·log|of(t)| + Σ factor·arg of(t) + the sums whose residues do not.
/// The arguments are continuous along the real line.
struct GaussianLogs {
  /// factor·log|of(t)|.
  struct Logarithm {
    Rational factor;  ///< not 0
    Polynomial of;    ///< not constant
    friend bool operator==(const Logarithm&, const Logarithm&) = default;
  };
  /// factor·arg of(t).
  struct Argument {
    Rational factor;        ///< not 0
    GaussianPolynomial of;  ///< without a real zero
    friend bool operator==(const Argument&, const Argument&) = default;
  };
  std::vector<Logarithm> logarithms;  ///< of real functions
  std::vector<Argument> arguments;    ///< continuous
  std::vector<LogSum> others;         ///< whose residues do not lie in ℚ(i)
};

/// The sums Σ α·log v(α, t) over the roots of irreducible polynomials in this form: conjugate
/// residues p ± iq give p·log|v(p + iq, t)|² − 2q·arg v(p + iq, t). Throws DomainError for a sum
/// with another factor than α.
GaussianLogs gaussian_logs(const std::vector<LogSum>& over_residues);

/// P with Σ factor·arg of = arg P + constant, a product of powers; no value where there are other
/// terms or a factor is not whole.
std::optional<GaussianPolynomial> single_argument(const GaussianLogs& logs);

/// arg g up to a constant, as Σ x·log v(x, t) over x = ±i/2 with v(−i/2, t) = g made monic.
/// Precondition: g has no real factor and is not constant, so that v depends on x.
LogSum argument_as_logs(const GaussianPolynomial& g);

}  // namespace phrame
