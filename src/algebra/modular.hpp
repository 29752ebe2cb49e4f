#pragma once
#include <optional>
#include <vector>

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

/// a ← a mod q ≠ 0.
void reduce(ModularPolynomial& a, const ModularPolynomial& q);

/// a·b mod q for deg a, deg b < deg q: where q changes with every product, twice as fast as FLINT's
/// nmod_poly_mulmod.
ModularPolynomial multiply_modulo(const ModularPolynomial& a, const ModularPolynomial& b,
                                  const ModularPolynomial& q);

/// a⁻¹ in 𝔽ₚ[t]/(q), and res(q, a) ≠ 0.
struct ModularInverse {
  ModularPolynomial inverse;
  ulong resultant;
};

/// No value where gcd(a, q) ≠ 1. Requires a ≠ 0, deg a < deg q, and an odd prime p < 2⁶².
/// Cost: Euclid's algorithm without divisions in Montgomery's form, 3·(deg q)² products of words.
std::optional<ModularInverse> modular_inverse(const ModularPolynomial& a,
                                              const ModularPolynomial& q);

/// The primes above 2⁶¹, ascending: so large that a bad one is never met in practice, and small
/// enough for FLINT's fastest word arithmetic and for `modular_inverse`.
class Primes {
 public:
  ulong next();

 private:
  std::size_t used_ = 0;
};

}  // namespace phrame
