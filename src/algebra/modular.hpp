#pragma once
#include <optional>
#include <vector>

#include "phrame/algebra/polynomial.hpp"

namespace phrame::inline v0 {

/// A machine word: a prime p, or a number modulo p, in [0, p).
using Word = ulong;

/// A polynomial over ℤ/p: nmod_poly with its lifetime. Both sides of an operation share p.
class ModularPolynomial {
 public:
  explicit ModularPolynomial(Word prime) { nmod_poly_init(raw(), prime); }  ///< 0
  ModularPolynomial(Word prime, const IntegerPolynomial& f) : ModularPolynomial(prime) {
    fmpz_poly_get_nmod_poly(raw(), f.get());
  }
  ModularPolynomial(Word prime, const std::vector<Word>& ascending);
  ModularPolynomial(const ModularPolynomial& other) : ModularPolynomial(other.prime()) {
    nmod_poly_set(raw(), other.raw());
  }
  ModularPolynomial(ModularPolynomial&& other) noexcept : ModularPolynomial(other.prime()) {
    nmod_poly_swap(raw(), other.raw());
  }
  ModularPolynomial& operator=(const ModularPolynomial& other) {
    nmod_poly_set(raw(), other.raw());
    return *this;
  }
  ModularPolynomial& operator=(ModularPolynomial&& other) noexcept {
    nmod_poly_swap(raw(), other.raw());
    return *this;
  }
  ~ModularPolynomial() { nmod_poly_clear(raw()); }

  Word prime() const { return raw()->mod.n; }
  long degree() const { return nmod_poly_degree(raw()); }
  bool is_zero() const { return nmod_poly_is_zero(raw()) != 0; }
  Word coefficient(long k) const { return nmod_poly_get_coeff_ui(raw(), k); }

  ModularPolynomial& operator+=(const ModularPolynomial& b) {
    return nmod_poly_add(raw(), raw(), b.raw()), *this;
  }
  ModularPolynomial& operator-=(const ModularPolynomial& b) {
    return nmod_poly_sub(raw(), raw(), b.raw()), *this;
  }
  ModularPolynomial& operator*=(const ModularPolynomial& b) {
    return nmod_poly_mul(raw(), raw(), b.raw()), *this;
  }
  ModularPolynomial& operator*=(Word c) {
    return nmod_poly_scalar_mul_nmod(raw(), raw(), c), *this;
  }
  /// c ≠ 0.
  ModularPolynomial& operator/=(Word c) { return *this *= nmod_inv(c, raw()->mod); }

  nmod_poly_struct* raw() { return &value_; }
  const nmod_poly_struct* raw() const { return &value_; }

 private:
  nmod_poly_struct value_;
};

ModularPolynomial differentiate(const ModularPolynomial& a);
Word evaluate(const ModularPolynomial& a, Word x);  ///< a(x)
/// The quotient of a by tᵏ.
ModularPolynomial shifted_down(const ModularPolynomial& a, long k);
/// The polynomial part of q·Σ valuesᵢ·t^{−i−1}: where that series is P/q, it is P, if there are
/// deg q values.
ModularPolynomial numerator_of_series(std::vector<Word> values, const ModularPolynomial& q);
/// The monic polynomial of degree n with these power sums s₁, …, sₙ of its roots. Requires p > n.
ModularPolynomial from_power_sums(Word prime, const std::vector<Word>& sums);
/// The degree of the gcd; −1 where both are 0.
long common_degree(const ModularPolynomial& a, const ModularPolynomial& b);
/// Is the gcd 1? Requires that a and b are not both 0.
bool are_coprime(const ModularPolynomial& a, const ModularPolynomial& b);
/// @{ Is gcd(a, b) seen to be constant, or a to have no multiple root, modulo one prime? It is
/// where that holds, but for rare exceptions, and costs far less than to find a divisor. a ≠ 0.
bool are_seen_coprime(const IntegerPolynomial& a, const IntegerPolynomial& b);
bool is_seen_squarefree(const IntegerPolynomial& a);
/// @}
/// Is a² + b² + c² seen to be no square in ℚ[t], as its value at some t is none modulo a prime? So
/// it is where that holds, but for one in 256, and costs far less than the sum.
bool sum_of_squares_is_seen_no_square(const Polynomial& a, const Polynomial& b,
                                      const Polynomial& c);
/// An irreducible factor, but for what it is.
struct FactorShape {
  long degree;
  long exponent;
};
/// Of all irreducible factors of a ≠ 0.
std::vector<FactorShape> shapes_of_factors(const ModularPolynomial& a);
/// ∏ b(τ)/c(τ) over the roots τ of a, in an algebraic closure, with multiplicities; no value where
/// a = 0, or c is 0 at one of them.
std::optional<Word> product_of_values(const ModularPolynomial& a, const ModularPolynomial& b,
                                      const ModularPolynomial& c);
Word power(Word x, long n, Word p);  ///< xⁿ modulo p; n ≥ 0
/// The residue of x modulo p.
Word residue(const Integer& x, Word p);

/// a ← a mod q ≠ 0.
void reduce(ModularPolynomial& a, const ModularPolynomial& q);

/// a·b mod q for deg a, deg b < deg q: where q changes with every product, twice as fast as FLINT's
/// nmod_poly_mulmod.
ModularPolynomial multiply_modulo(const ModularPolynomial& a, const ModularPolynomial& b,
                                  const ModularPolynomial& q);

/// a⁻¹ in 𝔽ₚ[t]/(q), and res(q, a) ≠ 0.
struct ModularInverse {
  ModularPolynomial inverse;
  Word resultant;
};

/// No value where gcd(a, q) ≠ 1. Requires a ≠ 0, deg a < deg q, and an odd prime p < 2⁶².
/// Cost: Euclid's algorithm without divisions in Montgomery's form, 3·(deg q)² products of words.
std::optional<ModularInverse> modular_inverse(const ModularPolynomial& a,
                                              const ModularPolynomial& q);

/// The primes above 2⁶¹, ascending: so large that a bad one is never met in practice, and small
/// enough for FLINT's fastest word arithmetic and for `modular_inverse`.
class Primes {
 public:
  Word next();

 private:
  std::size_t used_ = 0;
};

}  // namespace phrame
