#pragma once
#include <optional>

#include "phrame/algebra/polynomial.hpp"
#include "phrame/export.hpp"

namespace phrame::inline v0 {

/// A rational function over ℚ in lowest terms: gcd(numerator, denominator) = 1, the denominator
/// has coprime integer coefficients and a positive leading one. Zero is 0/1.
class PHRAME_API RationalFunction {
 public:
  RationalFunction() = default;  ///< 0
  /// Throws DomainError for a zero denominator.
  RationalFunction(Polynomial numerator, Polynomial denominator);
  /// The polynomial over 1.
  explicit RationalFunction(Polynomial polynomial);

  const Polynomial& numerator() const { return numerator_; }     ///< with the content and the sign
  const Polynomial& denominator() const;                         ///< primitive; 1 for a polynomial
  bool is_zero() const { return numerator_.is_zero(); }          ///< is it 0?
  bool is_polynomial() const { return denominator_.is_zero(); }  ///< is the denominator 1?
  /// deg numerator < deg denominator; 0 is proper.
  bool is_proper() const { return numerator_.degree() < denominator().degree(); }

  /// The value at t. Throws DomainError at a pole.
  Rational operator()(const Rational& t) const;

  /// @{ Exact, in lowest terms. Cost: a gcd.
  friend PHRAME_API RationalFunction operator+(const RationalFunction& a,
                                               const RationalFunction& b);
  friend PHRAME_API RationalFunction operator-(const RationalFunction& a,
                                               const RationalFunction& b);
  friend PHRAME_API RationalFunction operator*(const RationalFunction& a,
                                               const RationalFunction& b);
  friend PHRAME_API RationalFunction operator-(const RationalFunction& a);
  /// @}
  friend bool operator==(const RationalFunction&, const RationalFunction&) = default;

 private:
  Polynomial numerator_;
  Polynomial denominator_;  ///< 0 stands for 1, so that a moved-from value is 0/1
};

PHRAME_API RationalFunction differentiate(const RationalFunction& f);  ///< f′

/// @{ f(g(t)). Throws DomainError where g is a constant at which f has a pole.
PHRAME_API RationalFunction compose(const RationalFunction& f, const Polynomial& g);
PHRAME_API RationalFunction compose(const RationalFunction& f, const RationalFunction& g);
/// @}

/// The constant c where f = c; no value otherwise.
PHRAME_API std::optional<Rational> constant(const RationalFunction& f);

/// The bits of the greatest coefficient of the numerator and of the denominator, added.
PHRAME_API long bits_of(const RationalFunction& f);

/// Writes "(t^2 - 1)/(t + 3)", "-2/(t + 3)", or a polynomial where it is one.
PHRAME_API std::ostream& operator<<(std::ostream& out, const RationalFunction& f);

/// How large numbers may become in a computation whose input comes from others.
struct SizeLimits {
  long max_degree = 1000;    ///< of numerators and denominators
  long max_bits = 1L << 19;  ///< of the integers in them; 10^100000 has 332193
};

}  // namespace phrame
