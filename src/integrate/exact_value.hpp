#pragma once
#include <optional>
#include <vector>

#include "phrame/algebra/real_algebraic.hpp"
#include "phrame/export.hpp"

namespace phrame::inline v0 {

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
PHRAME_API ExactValue exact_value(const Rational& x);
/// Is it a rational number? Decided, as π, the logarithms and the arctangents, once those that add
/// up to a rational multiple of π are gone, make a transcendental number [Baker 1975].
PHRAME_API bool is_rational(const ExactValue& x);

/// The sum; no value where several have an irrational multiple of π.
PHRAME_API std::optional<ExactValue> sum_of(const std::vector<ExactValue>& values);
/// Throws DomainError where both have an irrational multiple of π.
PHRAME_API ExactValue operator+(const ExactValue& a, const ExactValue& b);
/// c·x.
PHRAME_API ExactValue operator*(const Rational& c, const ExactValue& x);

}  // namespace phrame
