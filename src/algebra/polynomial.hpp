#pragma once
#include <initializer_list>
#include <optional>
#include <utility>
#include <vector>

#include "phrame/algebra/handle.hpp"
#include "phrame/algebra/rational.hpp"
#include "phrame/export.hpp"

namespace phrame::inline v0 {

/// A polynomial over ℚ in one variable. Degree of 0 is −1.
class PHRAME_API Polynomial {
 public:
  Polynomial() = default;  ///< 0
  /// The coefficients of t⁰, t¹, …: {1, 0, 2} is 2t² + 1.
  Polynomial(std::initializer_list<Rational> ascending) : Polynomial(std::vector(ascending)) {}
  /// The same from a list.
  explicit Polynomial(const std::vector<Rational>& ascending);
  /// c · tᵏ, k ≥ 0.
  static Polynomial monomial(const Rational& c, long k);

  long degree() const { return fmpq_poly_degree(raw()); }  ///< −1 for 0
  /// @{ Is it 0; is it a constant, such as 0?
  bool is_zero() const { return fmpq_poly_is_zero(raw()) != 0; }
  bool is_constant() const { return degree() <= 0; }
  /// @}

  /// The coefficient of tᵏ, k ≥ 0; 0 beyond the degree.
  Rational coefficient(long k) const;
  /// The coefficient of the highest power; 0 for 0.
  Rational leading_coefficient() const { return is_zero() ? Rational(0) : coefficient(degree()); }
  std::vector<Rational> coefficients() const;  ///< ascending, degree() + 1 of them

  /// The value at t.
  Rational operator()(const Rational& t) const;

  /// @{ Exact.
  Polynomial& operator+=(const Polynomial& b);
  Polynomial& operator-=(const Polynomial& b);
  Polynomial& operator*=(const Polynomial& b);
  Polynomial& operator*=(const Rational& c);
  /// @}

  /// @{ Exact.
  friend Polynomial operator+(Polynomial a, const Polynomial& b) { return std::move(a += b); }
  friend Polynomial operator-(Polynomial a, const Polynomial& b) { return std::move(a -= b); }
  friend Polynomial operator*(Polynomial a, const Polynomial& b) { return std::move(a *= b); }
  friend Polynomial operator*(const Rational& c, Polynomial a) { return std::move(a *= c); }
  friend Polynomial operator-(Polynomial a) { return Rational(-1) * std::move(a); }
  /// @}
  /// Are all coefficients equal?
  friend bool operator==(const Polynomial& a, const Polynomial& b) {
    return fmpq_poly_equal(a.raw(), b.raw()) != 0;
  }

  // FLINT's own, for the files of this folder.
  fmpq_poly_struct* raw() { return handle_.get(); }
  const fmpq_poly_struct* raw() const { return handle_.get(); }

 private:
  flint::FmpqPoly handle_;
};

/// What divide() finds.
struct Division {
  Polynomial quotient;   ///< of any degree
  Polynomial remainder;  ///< of a lower degree than the divisor
};

/// a = quotient · b + remainder, deg remainder < deg b. Throws DomainError for b = 0.
PHRAME_API Division divide(const Polynomial& a, const Polynomial& b);
/// The remainder. Throws DomainError for b = 0.
PHRAME_API Polynomial operator%(const Polynomial& a, const Polynomial& b);
/// a % b, much faster where that is known to be far shorter than a. The quotient of
/// denominator(a)·a by the primitive part of b then has integer coefficients (Gauss's lemma), so
/// that no power of a leading coefficient is needed to divide.
PHRAME_API Polynomial short_remainder(const Polynomial& a, const Polynomial& b);
/// a / b, where b divides a. Throws DomainError where it does not.
PHRAME_API Polynomial exact_quotient(const Polynomial& a, const Polynomial& b);

/// The least common denominator of the coefficients, > 0.
PHRAME_API Integer denominator(const Polynomial& p);

/// The greatest common divisor with coprime integer coefficients and a positive leading one;
/// gcd(0, 0) = 0.
PHRAME_API Polynomial gcd(const Polynomial& a, const Polynomial& b);
/// a·b/gcd(a, b), for a, b ≠ 0.
PHRAME_API Polynomial lcm(const Polynomial& a, const Polynomial& b);

/// What extended_gcd() finds.
struct ExtendedGcd {
  Polynomial g;  ///< the greatest common divisor, monic; 0 for a = b = 0
  Polynomial s;  ///< the factor of a
  Polynomial t;  ///< the factor of b
};
/// g = gcd(a, b) = s·a + t·b, but monic.
PHRAME_API ExtendedGcd extended_gcd(const Polynomial& a, const Polynomial& b);

/// @{ p = content(p) · primitive_part(p); the primitive part has coprime integer coefficients and a
/// positive leading one, so the content carries the sign. Both are 0 for 0.
PHRAME_API Rational content(const Polynomial& p);
PHRAME_API Polynomial primitive_part(const Polynomial& p);
/// @}
/// The greatest c ≥ 0 such that p/c has integer coefficients for all of the polynomials p; 0 where
/// all are 0.
PHRAME_API Rational common_content(const std::vector<Polynomial>& polynomials);

PHRAME_API Polynomial differentiate(const Polynomial& p);  ///< p′
/// ∫₀ᵗ p.
PHRAME_API Polynomial antiderivative(const Polynomial& p);
/// p(q(t)).
PHRAME_API Polynomial compose(const Polynomial& p, const Polynomial& q);
/// pᵏ, k ≥ 0; p⁰ = 1.
PHRAME_API Polynomial pow(const Polynomial& p, long k);
/// √p, with a positive leading coefficient, where it is in ℚ[t]; no value where it is not.
PHRAME_API std::optional<Polynomial> square_root(const Polynomial& p);
/// p/gcd(p, p′), primitive: the same roots, each once. Throws DomainError for 0.
PHRAME_API Polynomial squarefree_part(const Polynomial& p);
/// Has p no multiple root? True for constants ≠ 0.
PHRAME_API bool is_squarefree(const Polynomial& p);

/// "t^2 - 1/2*t + 3", for messages.
PHRAME_API std::string to_string(const Polynomial& p);
/// Writes to_string(p).
PHRAME_API std::ostream& operator<<(std::ostream& out, const Polynomial& p);

/// A polynomial over ℤ, to be reduced modulo primes (modular.hpp).
using IntegerPolynomial = flint::FmpzPoly;
PHRAME_API IntegerPolynomial integer_primitive_part(const Polynomial& p);  ///< primitive_part(p)
PHRAME_API IntegerPolynomial integer_numerator(const Polynomial& p);       ///< denominator(p)·p
/// The bits of the greatest coefficient of primitive_part(p); 0 for 0.
PHRAME_API long primitive_bits(const Polynomial& p);
PHRAME_API Polynomial to_polynomial(const fmpz_poly_t p);  ///< p as a polynomial over ℚ

/// The sign of p(t) for small t > 0: that of its lowest coefficient, 0 for p = 0.
PHRAME_API int sign_after_zero(const Polynomial& p);
/// The sign of p(t) for t < 1 next to 1.
PHRAME_API int sign_before_one(const Polynomial& p);

}  // namespace phrame
