// The characteristic polynomial χ of c = n/d′ in A = 𝔽ₚ[t]/(d) from its power sums
// s_k = Tr(cᵏ), k ≤ N = deg d (Newton). Over ℤ,
//   res_t(d, n − x·d′) = lead(d)^{N−1} ∏ (n(z) − x d′(z)) = (−1)^N · res(d, d′) · χ(x).
#include "phrame/algebra/resultant.hpp"

#include <algorithm>
#include <optional>

#include "phrame/algebra/decomposition.hpp"
#include "phrame/algebra/error.hpp"
#include "phrame/algebra/hadamard.hpp"
#include "phrame/algebra/integer_fraction.hpp"
#include "phrame/algebra/modular_algebra.hpp"
#include "phrame/algebra/modular_lift.hpp"

namespace phrame::inline v0 {
namespace {

/// χ, monic. Needs p > N.
ModularPolynomial characteristic_polynomial(const ModularAlgebra& algebra,
                                            const ModularPolynomial& c) {
  std::vector<ulong> s = values_of_powers(algebra, algebra.trace(), c, algebra.size() + 1);
  s.erase(s.begin());
  return from_power_sums(algebra.prime(), s);
}

IntegerFraction simple_fraction(const Polynomial& n, const Polynomial& d) {
  if (d.is_constant()) throw DomainError("residue_polynomial: the denominator is constant");
  if (n.degree() >= d.degree()) throw DomainError("residue_polynomial: the fraction is not proper");
  if (!is_squarefree(d))
    throw DomainError("residue_polynomial: the denominator has a repeated root");
  return integer_fraction(n, d);
}

}  // namespace

namespace {

/// Up to Hadamard's bound.
Polynomial lifted_residue_polynomial(const Polynomial& n, const Polynomial& d) {
  const IntegerFraction f = integer_fraction(n, d);
  const auto image =
      [&](const std::vector<ModularPolynomial>& at) -> std::optional<ModularPolynomial> {
    const auto algebra = ModularAlgebra::make(at[1], d.degree());
    if (!algebra) return std::nullopt;
    ModularPolynomial r = characteristic_polynomial(*algebra, algebra->residue(at[0]));
    nmod_poly_scalar_mul_nmod(r.raw(), r.raw(), algebra->discriminant());
    return r;
  };
  const flint::FmpzPoly lifted = modular_lift({f.numerator, f.denominator}, d.degree() + 1,
                                              residue_bits(f.numerator, f.denominator), image);
  // The residues of n/d are those of numerator/d over `scale`: substitute x → scale·x.
  const Polynomial residues = to_polynomial(lifted.get());
  return primitive_part(compose(residues, Polynomial{0, Rational(f.scale)}));
}

}  // namespace

// A fraction of h(t) has each residue of the outer one deg h times: of those a curve has whose
// preimage is one of h(t), and the bound of the composed fraction is far above what they need.
Polynomial residue_polynomial(const Polynomial& n, const Polynomial& d) {
  const long distinct = distinct_residues_modulo_a_prime(n, d);
  const auto found =
      distinct == 0 ? std::nullopt : widest_decomposition(n, d, d.degree() / distinct);
  if (!found) return lifted_residue_polynomial(n, d);
  return pow(residue_polynomial(found->outer_n, found->outer_d), found->inner.degree());
}

long distinct_residues_modulo_a_prime(const Polynomial& n, const Polynomial& d) {
  const IntegerFraction f = simple_fraction(n, d);
  Primes primes;
  long most = 0;
  for (int attempt = 0; attempt < 2 && most < d.degree(); ++attempt) {
    const ulong p = primes.next();
    const auto algebra = ModularAlgebra::make(ModularPolynomial(p, f.denominator), d.degree());
    if (!algebra) continue;
    const ModularPolynomial chi =
        characteristic_polynomial(*algebra, algebra->residue(ModularPolynomial(p, f.numerator)));
    // p > deg χ, so that χ/gcd(χ, χ′) has all its roots, once.
    ModularPolynomial repeated(p);
    nmod_poly_derivative(repeated.raw(), chi.raw());
    nmod_poly_gcd(repeated.raw(), repeated.raw(), chi.raw());
    most = std::max(most, chi.degree() - repeated.degree());
  }
  return most;
}

bool residues_are_distinct_modulo_a_prime(const Polynomial& n, const Polynomial& d) {
  return distinct_residues_modulo_a_prime(n, d) == d.degree();
}

}  // namespace phrame
