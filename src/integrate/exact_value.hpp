#pragma once
#include <optional>

#include "phrame/algebra/power_product.hpp"
#include "phrame/integrate/endpoint.hpp"
#include "phrame/integrate/gaussian_logs.hpp"

namespace phrame {

/// rational + (pi + irrational_pi)·π + Σ factor·log(of) + Σ factor·arctan(of). In the logarithms
/// of > 1 and the factors are different, in the arctangents of > 0, of ≠ 1, and the arguments are
/// different. Where there is an irrational multiple of π it is the whole one: pi is 0.
struct ExactValue {
  /// factor·log(of), or factor·arctan(of).
  struct Term {
    Rational factor;  ///< not 0
    Rational of;      ///< the argument
    friend bool operator==(const Term&, const Term&) = default;
  };
  Rational rational;              ///< what is rational
  Rational pi;                    ///< the rational multiple of π
  std::vector<Term> logarithms;   ///< those of log
  std::vector<Term> arctangents;  ///< those of arctan
  /// The multiple of π, where it is irrational.
  std::optional<RealAlgebraic> irrational_pi = std::nullopt;
  friend bool operator==(const ExactValue&, const ExactValue&) = default;
};

/// This number.
ExactValue exact_value(const Rational& x);
/// Is it a rational number? Decided, as π, the logarithms and the arctangents, once those that add
/// up to a rational multiple of π are gone, make a transcendental number [Baker 1975].
bool is_rational(const ExactValue& x);

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

/// The sum; no value where several have an irrational multiple of π.
std::optional<ExactValue> sum_of(const std::vector<ExactValue>& values);
/// Throws DomainError where both have an irrational multiple of π.
ExactValue operator+(const ExactValue& a, const ExactValue& b);
/// c·x.
ExactValue operator*(const Rational& c, const ExactValue& x);

}  // namespace phrame
