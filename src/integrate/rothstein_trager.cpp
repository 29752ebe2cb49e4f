// d is irreducible over ℚ, so its roots are conjugate and every residue occurs equally often: the
// residue polynomial is qᵏ with q irreducible, and v = gcd(n − x d′, d) ∈ (ℚ[x]/(q))[t] has degree
// k. Modulo a prime p, 𝔽ₚ[x]/(q) need not be a field; Euclid's algorithm runs as if it were, and a
// leading coefficient without inverse, or a gcd of another degree, discards the prime.
#include "phrame/integrate/rothstein_trager.hpp"

#include <algorithm>
#include <optional>

#include "phrame/algebra/modular_bivariate.hpp"
#include "phrame/algebra/rational_lift.hpp"
#include "phrame/algebra/resultant.hpp"

namespace phrame {
namespace {

/// The coefficients of t⁰, …, tᵏ⁻¹ of a monic polynomial of degree k, `size` numbers each.
std::vector<Word> flattened(const ModularBivariate& v, long size) {
  std::vector<Word> list;
  for (std::size_t j = 0; j + 1 < v.size(); ++j)
    for (long i = 0; i < size; ++i) list.push_back(v[j].coefficient(i));
  return list;
}

/// gcd(n − x d′, d), monic of degree k in t, over ℚ[x]/(q): the first candidate that one more
/// prime confirms.
Bivariate residue_gcd(const SimpleFraction& f, const Polynomial& q, long k) {
  const Integer scale = denominator(f.numerator);
  const IntegerPolynomial n = integer_numerator(f.numerator);
  const IntegerPolynomial d = integer_primitive_part(f.denominator);
  const IntegerPolynomial modulus = integer_primitive_part(q);
  RationalLift lift(static_cast<std::size_t>(k * q.degree()));
  Primes primes;
  for (;;) {
    const Word p = primes.next();
    const ModularPolynomial q_p(p, modulus);
    const ModularPolynomial n_p(p, n);
    const ModularPolynomial d_p(p, d);
    const Word s = residue(scale, p);
    if (q_p.degree() != q.degree() || d_p.degree() != f.denominator.degree() || s == 0) continue;
    // a = d, b = n − (scale·x)·d′, up to the unit `scale`.
    ModularPolynomial slope = differentiate(d_p);
    slope *= p - s;
    ModularBivariate a;
    ModularBivariate b;
    for (long j = 0; j <= d_p.degree(); ++j) {
      a.emplace_back(p, std::vector{d_p.coefficient(j)});
      b.emplace_back(p, std::vector{n_p.coefficient(j), slope.coefficient(j)});
      reduce(b.back(), q_p);
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
