#pragma once
#include <map>
#include <optional>

#include "phrame/algebra/rational_function.hpp"

namespace phrame::inline v0 {

/// A rational function c·tᵏ·n/d that is brought to lowest terms only when it must be, because a gcd
/// after every step is what makes long computations in ℚ(t) slow. A monomial has n = d = 1, and its
/// arithmetic is that of c and k. Invariant: n(0)·d(0) ≠ 0, a constant n or d is 1, and zero has
/// c = k = 0, n = d = 1.
/// A result beyond the limits, even in lowest terms, throws Undecided; an operation that would take
/// much longer than its limits allow is not begun. After an exception the value is unspecified.
class Unreduced {
 public:
  /// A constant.
  explicit Unreduced(Rational constant = 0) : scale_(std::move(constant)) {}
  /// Of any function.
  explicit Unreduced(const RationalFunction& f);
  /// c·tᵏ, k of any sign.
  static Unreduced monomial(const Rational& c, long k);

  bool is_zero() const { return scale_ == 0; }  ///< is it 0?
  /// Is it written as c·tᵏ?
  bool is_monomial() const { return numerator_.is_constant() && denominator_.is_constant(); }
  /// Is it written without a denominator?
  bool is_polynomial() const { return shift_ >= 0 && denominator_.is_constant(); }
  const Rational& scale() const { return scale_; }  ///< c
  long shift() const { return shift_; }             ///< k

  /// The value, if it is a constant. Cost: a gcd where it is not a monomial.
  std::optional<Rational> constant() const;
  /// In lowest terms. Throws Undecided beyond the limits.
  RationalFunction reduced(const SizeLimits& limits) const;

  void negate() { scale_ = -scale_; }                           ///< becomes −this
  void multiply(const Unreduced& b, const SizeLimits& limits);  ///< becomes this·b
  /// Becomes this/b. Throws DomainError for b = 0.
  void divide(const Unreduced& b, const SizeLimits& limits);
  /// Becomes this^exponent. Throws DomainError for a power ≤ 0 of 0.
  void raise(const Integer& exponent, const SizeLimits& limits);

 private:
  void invert();
  void cancel();
  long degree() const;
  void settle(const SizeLimits& limits);

  Rational scale_;
  long shift_ = 0;
  Polynomial numerator_{1};
  Polynomial denominator_{1};
};

/// A growing sum. Monomials are collected by their exponent and polynomials added as such;
/// fractions are added in pairs of like length, so that most additions are of small ones.
class UnreducedSum {
 public:
  /// With its first term.
  UnreducedSum(const Unreduced& first, const SizeLimits& limits) : limits_(limits) { add(first); }

  /// Adds a. Throws Undecided beyond the limits.
  void add(const Unreduced& a);
  Unreduced total() const;  ///< the sum, not reduced

 private:
  RationalFunction laurent_part() const;

  SizeLimits limits_;
  std::map<long, Rational> monomials_;
  Polynomial polynomial_;
  /// Like the digits of a binary counter: the k-th is missing or the sum of 2ᵏ fractions.
  std::vector<std::optional<RationalFunction>> fractions_;
};

}  // namespace phrame
