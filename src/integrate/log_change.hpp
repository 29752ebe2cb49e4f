#pragma once
#include "phrame/algebra/power_product.hpp"
#include "phrame/integrate/endpoint.hpp"
#include "phrame/integrate/exact_value.hpp"
#include "phrame/integrate/gaussian_logs.hpp"

namespace phrame::inline v0 {

/// The change of logarithms with residues in ℚ(i) on the way from a to b, each a logarithm of a
/// positive rational or an angle of a Gaussian rational with whole turns:
///   Σ exponent·log|base| over the sizes + Σ exponent·(arg base + 2π·whole) over the turns.
/// At ±∞ it is the limit, in which log|t| is left out: the factors of it add up to 0 where there is
/// an integral.
struct LogChange {
  /// exponent·(arg base + 2π·whole).
  struct Turn {
    Power power;    ///< base and exponent
    Integer whole;  ///< with −π < arg base ≤ π
  };
  std::vector<Power> sizes;  ///< those of logarithms
  std::vector<Turn> turns;   ///< those of arguments
};

/// Precondition: the ends are rational or infinite, and no zero of a logarithm. Throws DomainError
/// where logs.others is not empty.
LogChange log_change(const GaussianLogs& logs, const Endpoint& a, const Endpoint& b);

/// The sum over π, where it is rational; no value where it is not. Decided: by Baker's theorem the
/// sum is no rational multiple of π unless the sizes cancel and the turns are on a ray.
std::optional<Rational> multiple_of_pi(const LogChange& change);

/// rational + change, in finite terms. Turns that add up to a rational multiple of π are written as
/// that: π/4 for arctan(1/2) + arctan(1/3).
ExactValue exact_value(const Rational& rational, const LogChange& change);
/// The same plus multiple·π.
ExactValue exact_value(const Rational& rational, LogChange change, const RealAlgebraic& multiple);

}  // namespace phrame
