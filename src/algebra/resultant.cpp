// The characteristic polynomial χ of c = n/d′ in A = 𝔽ₚ[t]/(d) from its power sums
// s_k = Tr(cᵏ), k ≤ N = deg d: χ reversed is exp(−Σ s_k zᵏ/k) (Newton). Over ℤ,
//   res_t(d, n − x·d′) = lead(d)^{N−1} ∏ (n(z) − x d′(z)) = (−1)^N · res(d, d′) · χ(x).
#include "phrame/algebra/resultant.hpp"

#include <algorithm>
#include <optional>

#include "phrame/algebra/error.hpp"
#include "phrame/algebra/hadamard.hpp"
#include "phrame/algebra/modular_algebra.hpp"
#include "phrame/algebra/modular_lift.hpp"

namespace phrame {
namespace {

/// χ, monic. Needs p > N.
ModularPolynomial characteristic_polynomial(const ModularAlgebra& algebra,
                                            const ModularPolynomial& c) {
  const slong n = algebra.size();
  const std::vector<ulong> s = values_of_powers(algebra, algebra.trace(), c, n + 1);
  ModularPolynomial series(algebra.prime());  // −Σ s_k zᵏ/k
  const nmod_t mod = series.raw()->mod;
  for (slong k = 1; k <= n; ++k) {
    const ulong over_k = nmod_div(s[static_cast<std::size_t>(k)], static_cast<ulong>(k), mod);
    nmod_poly_set_coeff_ui(series.raw(), k, nmod_neg(over_k, mod));
  }
  nmod_poly_exp_series(series.raw(), series.raw(), n + 1);
  nmod_poly_reverse(series.raw(), series.raw(), n + 1);
  return series;
}

/// n/d scaled to integer polynomials: n = numerator/scale, d primitive.
struct IntegerFraction {
  flint::FmpzPoly numerator;
  flint::Fmpz scale;
  flint::FmpzPoly denominator;
};

IntegerFraction integer_fraction(const Polynomial& n, const Polynomial& d) {
  if (d.is_constant()) throw DomainError("residue_polynomial: the denominator is constant");
  if (n.degree() >= d.degree()) throw DomainError("residue_polynomial: the fraction is not proper");
  if (!is_squarefree(d))
    throw DomainError("residue_polynomial: the denominator has a repeated root");
  const Polynomial scaled = (1 / content(d)) * n;
  IntegerFraction f;
  fmpq_poly_get_numerator(f.numerator.get(), scaled.raw());
  fmpz_set(f.scale.get(), fmpq_poly_denref(scaled.raw()));
  f.denominator = integer_primitive_part(d);
  return f;
}

}  // namespace

Polynomial residue_polynomial(const Polynomial& n, const Polynomial& d) {
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
  return primitive_part(compose(residues, Polynomial{0, Rational(f.scale.get())}));
}

long distinct_residues_modulo_a_prime(const Polynomial& n, const Polynomial& d) {
  const IntegerFraction f = integer_fraction(n, d);
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
