#pragma once
#include <optional>
#include <vector>

#include "phrame/algebra/modular.hpp"

namespace phrame::inline v0 {

/// 𝔽ₚ[t]/(d), d squarefree of degree N ≥ 1, with the linear forms on it. A form ℓ is the list of
/// its values at 1, t, …, t^{N−1}, kept as a polynomial in z: Σ ℓ(tᵏ) zᵏ.
class ModularAlgebra {
 public:
  /// d modulo p; no value where p divides lead(d), so that the degree is not `size`, or the
  /// discriminant.
  static std::optional<ModularAlgebra> make(const ModularPolynomial& d, long size);

  const ModularPolynomial& modulus() const { return modulus_; }  ///< d
  long size() const { return modulus_.degree(); }
  ulong prime() const { return modulus_.prime(); }
  ulong discriminant() const { return derivative_inverse_.resultant; }  ///< res(d, d′)

  ModularPolynomial variable() const;  ///< t modulo d
  /// n/d′.
  ModularPolynomial residue(const ModularPolynomial& n) const {
    return multiply(n, derivative_inverse_.inverse);
  }
  ModularPolynomial multiply(const ModularPolynomial& a, const ModularPolynomial& b) const;
  ModularPolynomial trace() const;
  /// The form b ↦ ℓ(a·b).
  ModularPolynomial compose(const ModularPolynomial& form, const ModularPolynomial& a) const;

 private:
  explicit ModularAlgebra(const ModularPolynomial& d);

  ModularPolynomial modulus_;
  ModularPolynomial derivative_;
  ModularInverse derivative_inverse_;
  ModularPolynomial reversed_;
  ModularPolynomial reversed_inverse_;   ///< 1/rev(d) modulo z^{2N}
  ModularPolynomial remainder_inverse_;  ///< 1/rev(d) modulo z^{N+1}, for FLINT's remainder
};

/// ℓ(a).
Word value_of(const ModularPolynomial& form, const ModularPolynomial& a);

/// ℓ(cᵏ) for 0 ≤ k < count: a power projection, with about 2√count products [Shoup 1999].
std::vector<ulong> values_of_powers(const ModularAlgebra& algebra, const ModularPolynomial& form,
                                    const ModularPolynomial& c, long count);

/// f(c) for each f of the list, not empty: with M the greatest number of coefficients and r the
/// length of the list about 2√(r·M) products [Paterson, Stockmeyer 1973].
std::vector<ModularPolynomial> values_at(const ModularAlgebra& algebra,
                                         const std::vector<ModularPolynomial>& list,
                                         const ModularPolynomial& c);

}  // namespace phrame
