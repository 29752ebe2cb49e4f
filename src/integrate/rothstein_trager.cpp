// d is irreducible over ℚ, so its roots are conjugate and every residue occurs equally often: the
// residue polynomial is qᵏ with q irreducible, and v = gcd(n − x d′, d) ∈ (ℚ[x]/(q))[t] has degree
// k. Modulo a prime p, 𝔽ₚ[x]/(q) need not be a field; Euclid's algorithm runs as if it were, and a
// leading coefficient without inverse, or a gcd of another degree, discards the prime.
#include "phrame/integrate/rothstein_trager.hpp"

#include <algorithm>
#include <optional>

#include "phrame/algebra/modular.hpp"
#include "phrame/algebra/rational_lift.hpp"
#include "phrame/algebra/resultant.hpp"

namespace phrame {
namespace {

/// Polynomials in t over 𝔽ₚ[x]/(q): the coefficients of t⁰, t¹, …, the last one not 0.
using ModularBivariate = std::vector<ModularPolynomial>;

void normalize(ModularBivariate& f) {
  while (!f.empty() && f.back().is_zero()) f.pop_back();
}

/// f / lead(f), or no value where the leading coefficient is a zero divisor.
bool make_monic(ModularBivariate& f, const ModularPolynomial& q) {
  ModularPolynomial inverse(q.prime());
  if (nmod_poly_invmod(inverse.raw(), f.back().raw(), q.raw()) == 0) return false;
  for (auto& c : f) nmod_poly_mulmod(c.raw(), c.raw(), inverse.raw(), q.raw());
  return true;
}

/// a modulo the monic b, in place.
void reduce(ModularBivariate& a, const ModularBivariate& b, const ModularPolynomial& q) {
  ModularPolynomial product(q.prime());
  while (a.size() >= b.size()) {
    const std::size_t shift = a.size() - b.size();
    for (std::size_t k = 0; k + 1 < b.size(); ++k) {
      nmod_poly_mulmod(product.raw(), a.back().raw(), b[k].raw(), q.raw());
      nmod_poly_sub(a[shift + k].raw(), a[shift + k].raw(), product.raw());
    }
    a.pop_back();
    normalize(a);
  }
}

std::optional<ModularBivariate> monic_gcd(ModularBivariate a, ModularBivariate b,
                                          const ModularPolynomial& q) {
  while (!b.empty()) {
    if (!make_monic(b, q)) return std::nullopt;
    reduce(a, b, q);
    std::swap(a, b);
  }
  if (!make_monic(a, q)) return std::nullopt;
  return a;
}

/// The coefficients of t⁰, …, tᵏ⁻¹ of a monic polynomial of degree k, `size` numbers each.
std::vector<ulong> flattened(const ModularBivariate& v, long size) {
  std::vector<ulong> list;
  for (std::size_t j = 0; j + 1 < v.size(); ++j)
    for (long i = 0; i < size; ++i) list.push_back(v[j].coefficient(i));
  return list;
}

/// gcd(n − x d′, d), monic of degree k in t, over ℚ[x]/(q): the first candidate that one more
/// prime confirms.
Bivariate residue_gcd(const SimpleFraction& f, const Polynomial& q, long k) {
  const Polynomial scale{Rational(fmpq_poly_denref(f.numerator.raw()))};
  const flint::FmpzPoly n = [&] {
    flint::FmpzPoly result;
    fmpq_poly_get_numerator(result.get(), f.numerator.raw());
    return result;
  }();
  const flint::FmpzPoly d = integer_primitive_part(f.denominator);
  const flint::FmpzPoly modulus = integer_primitive_part(q);
  RationalLift lift(static_cast<std::size_t>(k * q.degree()));
  Primes primes;
  for (;;) {
    const ulong p = primes.next();
    const ModularPolynomial q_p(p, modulus);
    const ModularPolynomial n_p(p, n);
    const ModularPolynomial d_p(p, d);
    const ulong s = fmpz_fdiv_ui(fmpq_poly_denref(f.numerator.raw()), p);
    if (q_p.degree() != q.degree() || d_p.degree() != f.denominator.degree() || s == 0) continue;
    // a = d, b = n − (scale·x)·d′, up to the unit `scale`.
    ModularPolynomial slope(p);
    nmod_poly_derivative(slope.raw(), d_p.raw());
    ModularBivariate a;
    ModularBivariate b;
    for (long j = 0; j <= d_p.degree(); ++j) {
      a.emplace_back(p);
      nmod_poly_set_coeff_ui(a.back().raw(), 0, d_p.coefficient(j));
      b.emplace_back(p);
      nmod_poly_set_coeff_ui(b.back().raw(), 0, n_p.coefficient(j));
      const ulong c = nmod_mul(s, slope.coefficient(j), q_p.raw()->mod);
      nmod_poly_set_coeff_ui(b.back().raw(), 1, nmod_neg(c, q_p.raw()->mod));
      nmod_poly_rem(b.back().raw(), b.back().raw(), q_p.raw());
    }
    normalize(b);
    const auto gcd_p = monic_gcd(std::move(a), std::move(b), q_p);
    if (!gcd_p || static_cast<long>(gcd_p->size()) != k + 1) continue;
    if (const auto v = lift.include(flattened(*gcd_p, q.degree()), p))
      return monic_from_rows(*v, q.degree());
  }
}

}  // namespace

LogSum rothstein_trager(const SimpleFraction& f) {
  const Polynomial residues = residue_polynomial(f.numerator, f.denominator);
  const Polynomial q = squarefree_part(residues);
  const QuotientRing ring(q);
  return {q, ring.reduce(Polynomial{0, 1}), residue_gcd(f, q, residues.degree() / q.degree())};
}

std::vector<LogSum> merge_equal_residues(std::vector<LogSum> sums) {
  std::vector<LogSum> merged;
  for (LogSum& sum : sums) {
    const auto same = [&](const LogSum& other) {
      return other.index == sum.index && other.residue == sum.residue;
    };
    const auto at = std::find_if(merged.begin(), merged.end(), same);
    if (at == merged.end()) {
      merged.push_back(std::move(sum));
      continue;
    }
    const QuotientRing ring(sum.index);
    std::vector<Polynomial> product(
        static_cast<std::size_t>(at->argument.degree() + sum.argument.degree() + 1));
    for (long i = 0; i <= at->argument.degree(); ++i)
      for (long j = 0; j <= sum.argument.degree(); ++j)
        product[static_cast<std::size_t>(i + j)] +=
            ring.multiply(at->argument.coefficient(i), sum.argument.coefficient(j));
    at->argument = Bivariate(std::move(product));
  }
  return merged;
}

}  // namespace phrame
