#pragma once
#include <map>

#include "phrame/algebra/polynomial.hpp"
#include "phrame/export.hpp"

namespace phrame::inline v0 {

/// √d·√e = factor·√radicand.
struct RootProduct {
  Integer factor;    ///< ≥ 1
  Integer radicand;  ///< ≥ 1
};
/// The product, found by the gcd of d and e alone, so that the radicand may have square factors.
/// Throws DomainError for d or e < 1.
PHRAME_API RootProduct multiply_roots(const Integer& d, const Integer& e);

/// A field ℚ(√d, √e, …) with integers d, e, … ≥ 1, given by the integers, up to squares, whose
/// roots are in it.
class PHRAME_API RootField {
 public:
  /// Is √d in it?
  bool contains(const Integer& d) const;
  /// Makes it contain √d.
  void adjoin(const Integer& d);
  /// Integers whose roots are a basis of it over ℚ, 1 first; the k-th that was adjoined is at 2ᵏ⁻¹.
  const std::vector<Integer>& radicands() const { return radicands_; }

 private:
  std::vector<Integer> radicands_{1};
};

/// For each root that was adjoined the field of the others. The automorphisms that fix one of these
/// fields generate all automorphisms.
PHRAME_API std::vector<RootField> fields_without_a_root(const RootField& field);

/// Σ c·√d with c ≠ 0 in ℚ or ℚ[t] and integers d ≥ 1, no two of which have a product that is a
/// square. Such roots are linearly independent over ℚ [Besicovitch 1940], so that only 0 has no
/// term: equality is decided exactly, and no integer has to be factored for it.
template <class C>
class SurdSum {
 public:
  SurdSum() = default;  ///< 0
  /// a + b·√d. Throws DomainError for d < 1.
  // NOLINTNEXTLINE(google-explicit-constructor)
  SurdSum(const C& a, const C& b = {}, const Integer& d = 1) {
    add(a, 1);
    add(b, d);
  }

  /// The coefficients c by d.
  const std::map<Integer, C>& terms() const { return terms_; }
  /// The coefficient of √1.
  C rational_part() const { return terms_.contains(1) ? terms_.at(1) : C{}; }
  bool is_rational() const { return count_roots() == 0; }  ///< has it no root?
  bool is_zero() const { return terms_.empty(); }          ///< has it no term?
  /// The number of terms without that of √1.
  std::size_t count_roots() const { return terms_.size() - terms_.count(1); }

  /// Adds c·√d. Throws DomainError for d < 1.
  void add(const C& c, const Integer& d);

  /// @{ Exact.
  friend SurdSum operator+(SurdSum x, const SurdSum& y) {
    for (const auto& [d, c] : y.terms_) x.add(c, d);
    return x;
  }
  friend SurdSum operator*(const Rational& r, const SurdSum& x) {
    SurdSum product;
    for (const auto& [d, c] : x.terms_) product.add(r * c, d);
    return product;
  }
  friend SurdSum operator-(const SurdSum& x) { return Rational(-1) * x; }
  friend SurdSum operator-(const SurdSum& x, const SurdSum& y) { return x + -y; }
  /// @}
  /// Are they the same number? Decided, however they are written.
  friend bool operator==(const SurdSum& x, const SurdSum& y) { return (x - y).is_zero(); }

 private:
  std::map<Integer, C> terms_;
};

/// A number that is a sum of square roots.
using Surd = SurdSum<Rational>;
/// A polynomial whose coefficients are such numbers.
using SurdPolynomial = SurdSum<Polynomial>;

/// The exact product.
template <class A, class B>
auto operator*(const SurdSum<A>& x, const SurdSum<B>& y) {
  SurdSum<decltype(A() * B())> product;
  for (const auto& [d, a] : x.terms())
    for (const auto& [e, b] : y.terms()) {
      const auto [factor, radicand] = multiply_roots(d, e);
      product.add(Rational(factor) * (a * b), radicand);
    }
  return product;
}

/// Throws DomainError for y = 0.
PHRAME_API Surd operator/(const Surd& x, const Surd& y);
/// −1, 0 or 1.
PHRAME_API int sign(const Surd& x);

/// ℚ(√d, …) for the d of the terms.
template <class C>
RootField field_of(const SurdSum<C>& x) {
  RootField field;
  for (const auto& [d, c] : x.terms()) field.adjoin(d);
  return field;
}

/// x with −c·√d for each c·√d where √d is not in `fixed`: its image by an automorphism, if the
/// field of x has degree 1 or 2 over `fixed`.
template <class C>
SurdSum<C> conjugate(const SurdSum<C>& x, const RootField& fixed) {
  SurdSum<C> result;
  for (const auto& [d, c] : x.terms()) result.add(fixed.contains(d) ? c : -c, d);
  return result;
}

/// A subfield over which field_of(x) has degree 2, such as ℚ for a quadratic field. Precondition: x
/// is not rational.
template <class C>
RootField half_field(const SurdSum<C>& x) {
  const Integer& outside = x.terms().rbegin()->first;
  RootField half;
  for (const auto& [d, c] : x.terms())
    if (!half.contains(multiply_roots(d, outside).radicand)) half.adjoin(d);
  return half;
}

/// The coefficients of t⁰, t¹, …
PHRAME_API SurdPolynomial surd_polynomial(const std::vector<Surd>& ascending);
PHRAME_API SurdPolynomial differentiate(const SurdPolynomial& p);  ///< p′
PHRAME_API long degree(const SurdPolynomial& p);                   ///< −1 for 0
/// The coefficient of tᵏ.
PHRAME_API Surd coefficient(const SurdPolynomial& p, long k);

/// p(x).
PHRAME_API Surd evaluate(const Polynomial& p, const Surd& x);

/// a + b·√d, d an integer that is no square, with √d = i·√|d| for d < 0; b = 0 and d = 1 for a
/// rational number.
struct QuadraticNumber {
  Rational a;     ///< the rational part
  Rational b;     ///< the factor of the root
  Integer d = 1;  ///< the radicand
  friend bool operator==(const QuadraticNumber&, const QuadraticNumber&) = default;
};

/// The root with b ≥ 0 of p, which is irreducible over ℚ and of degree 1 or 2. Throws DomainError
/// for other degrees.
PHRAME_API QuadraticNumber quadratic_root(const Polynomial& p);

/// x = root²·rest for an integer x ≥ 1. The rest is 1 where x is a square, and has no factor p²
/// with p ≤ 10⁴. (Finding all square factors is as hard as factoring x.)
struct SquareFactor {
  Integer root;  ///< ≥ 1
  Integer rest;  ///< ≥ 1
};
/// Throws DomainError for x < 1. Cost: divisions by the numbers up to 10⁴.
PHRAME_API SquareFactor split_square(const Integer& x);

template <class C>
void SurdSum<C>::add(const C& c, const Integer& d) {
  if (c == C{}) return;
  for (auto place = terms_.begin(); place != terms_.end(); ++place) {
    const RootProduct product = multiply_roots(d, place->first);
    if (product.radicand != 1) continue;
    place->second += Rational(product.factor, place->first) * c;
    if (place->second == C{}) terms_.erase(place);
    return;
  }
  const RootProduct root = multiply_roots(d, 1);
  terms_.emplace(root.radicand, Rational(root.factor) * c);
}

}  // namespace phrame
