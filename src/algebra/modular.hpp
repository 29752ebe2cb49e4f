#pragma once
#include "phrame/algebra/polynomial.hpp"

namespace phrame {

/// A polynomial over ℤ/p: nmod_poly with its lifetime. Both sides of an operation share p.
class ModularPolynomial {
 public:
  explicit ModularPolynomial(ulong prime) { nmod_poly_init(raw(), prime); }
  ModularPolynomial(ulong prime, const flint::FmpzPoly& f) : ModularPolynomial(prime) {
    fmpz_poly_get_nmod_poly(raw(), f.get());
  }
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

  ulong prime() const { return raw()->mod.n; }
  long degree() const { return nmod_poly_degree(raw()); }
  bool is_zero() const { return nmod_poly_is_zero(raw()) != 0; }
  ulong coefficient(long k) const { return nmod_poly_get_coeff_ui(raw(), k); }

  nmod_poly_struct* raw() { return &value_; }
  const nmod_poly_struct* raw() const { return &value_; }

 private:
  nmod_poly_struct value_;
};

/// The primes above 2⁶¹, ascending: so large that a bad one is never met in practice, and small
/// enough for FLINT's fastest word arithmetic.
class Primes {
 public:
  ulong next() {
    static const ulong first = n_nextprime(1UL << 61, 0);
    return last_ = last_ == 0 ? first : n_nextprime(last_, 0);
  }

 private:
  ulong last_ = 0;
};

}  // namespace phrame
