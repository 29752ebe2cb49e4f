#pragma once
#include "phrame/algebra/polynomial.hpp"
#include "phrame/export.hpp"

namespace phrame::inline v0 {

/// A polynomial in t whose coefficients are polynomials in x: an element of ℚ[x][t].
class PHRAME_API Bivariate {
 public:
  Bivariate() = default;  ///< 0
  /// The coefficients of t⁰, t¹, …, each a polynomial in x.
  explicit Bivariate(std::vector<Polynomial> ascending);

  long degree() const { return static_cast<long>(coefficients_.size()) - 1; }  ///< in t
  bool is_zero() const { return coefficients_.empty(); }                       ///< is it 0?
  /// Is it a number?
  bool is_constant() const { return degree() <= 0 && coefficient(0).is_constant(); }
  /// The coefficient of tᵏ; 0 beyond the degree.
  Polynomial coefficient(long k) const;
  /// The coefficients of t⁰, t¹, …; the last is not 0.
  const std::vector<Polynomial>& coefficients() const { return coefficients_; }

  friend bool operator==(const Bivariate&, const Bivariate&) = default;

 private:
  std::vector<Polynomial> coefficients_;  ///< the last one is not 0
};

/// @{ Arithmetic.
PHRAME_API Bivariate operator+(const Bivariate& a, const Bivariate& b);
PHRAME_API Bivariate operator*(const Bivariate& a, const Bivariate& b);
PHRAME_API Bivariate operator*(const Rational& c, const Bivariate& v);
/// @}

/// Cuts the list into rows of `size` ≥ 1 numbers, of which its length is a multiple, and makes each
/// row a polynomial.
PHRAME_API std::vector<Polynomial> from_rows(const std::vector<Rational>& list, long size);

/// v ≠ 0 divided by its content: all of its numbers are integers without a common divisor, and the
/// leading coefficient has a positive leading coefficient.
PHRAME_API Bivariate primitive_part(const Bivariate& v);
/// The coefficients of t⁰, t¹, … of primitive_part(v).
PHRAME_API std::vector<IntegerPolynomial> integer_rows(const Bivariate& v);

/// The value at t = `t`: a polynomial in x.
PHRAME_API Polynomial evaluate_at(const Bivariate& v, const Rational& t);

/// Arithmetic in ℚ[x]/(q), deg q ≥ 1. Elements are polynomials of degree < deg q.
class PHRAME_API QuotientRing {
 public:
  /// Throws DomainError for a constant q.
  explicit QuotientRing(Polynomial q);

  const Polynomial& modulus() const { return modulus_; }  ///< q
  /// @{ The representative of degree < deg q in x.
  Polynomial reduce(const Polynomial& a) const { return a % modulus_; }
  Bivariate reduce(const Bivariate& v) const;
  /// @}
  /// a·b.
  Polynomial multiply(const Polynomial& a, const Polynomial& b) const { return (a * b) % modulus_; }
  /// n·a⁻¹. Throws DomainError where gcd(a, q) ≠ 1. Cost: one inverse
  /// modulo each of several primes, about as many as the coefficients of the result have words; how
  /// many are needed is bounded beforehand.
  Polynomial divide(const Polynomial& n, const Polynomial& a) const;
  /// Σ a(α) over the roots α of q, with multiplicity.
  Rational trace(const Polynomial& a) const;

 private:
  Polynomial modulus_;
};

/// s₁, …, s_count, the sums of the k-th powers of the roots of the monic polynomial
/// tⁿ + c₁tⁿ⁻¹ + … + cₙ, by Newton's identities: s_k = −k·c_k − Σ_{0<j<k} c_j·s_{k−j}.
/// `c` holds c₁, …, cₙ; `multiply` is the product of the coefficient ring.
template <class T, class Multiply>
std::vector<T> power_sums(const std::vector<T>& c, long count, Multiply multiply) {
  const auto n = static_cast<long>(c.size());
  const auto at = [](auto& list, long k) -> auto& { return list[static_cast<std::size_t>(k - 1)]; };
  std::vector<T> s;
  for (long k = 1; k <= count; ++k) {
    T sum{};
    if (k <= n) sum += Rational(k) * at(c, k);
    for (long j = 1; j < k && j <= n; ++j) sum += multiply(at(c, j), at(s, k - j));
    s.push_back(Rational(-1) * sum);
  }
  return s;
}

}  // namespace phrame
