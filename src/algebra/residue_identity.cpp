// Let v = Σ v_ij xⁱtʲ ∈ ℤ[x, t] have the degrees M in x and k in t, and c = n/(s·d′) with n, d ∈
// ℤ[t], s ∈ ℤ, N = deg d. With c put in and its denominator multiplied out, v becomes
//   H(t) = Σ v_ij nⁱ (s·d′)^{M−i} tʲ ∈ ℤ[t],  deg H ≤ D = M(N − 1) + k,
// and H(z) = (s·d′(z))^M·v(c(z), z). Where this is not 0 at one root of d, it is 0 at none of an
// irreducible factor e of d over ℤ, of degree r, and
//   Res = lead(e)^D·∏_{e(z)=0} H(z)
// is an integer ≠ 0. With B = max(‖n‖₁, ‖s·d′‖₁), |H(z)| ≤ ‖v‖₁·B^M·max(1, |z|)^D, so that
//   |Res| ≤ ‖v‖₁^r·B^{Mr}·‖e‖₂^D,
// as Mahler's measure lead(e)·∏ max(1, |z|) of e is no greater than ‖e‖₂ [Landau 1905].
// Let p be a prime that divides neither lead(d), nor s, nor the discriminant of d, and let v(c, t)
// = 0 in 𝔽ₚ[t]/(d). Then H = p·U + d·V over ℤ₍ₚ₎, the fractions without p below, so that H(z) =
// p·U(z), and U(z) is integral over ℤ₍ₚ₎, as z is: pʳ divides Res. So does Pʳ for the product P of
// such primes, and
//   P > ‖v‖₁·B^M·‖e‖₂^{D/r}  for every e
// proves that v(c(z), z) = 0 at every root of d.
#include "phrame/algebra/residue_identity.hpp"

#include <algorithm>

#include "phrame/algebra/factor.hpp"
#include "phrame/algebra/hadamard.hpp"
#include "phrame/algebra/integer_fraction.hpp"
#include "phrame/algebra/modular_algebra.hpp"

namespace phrame::inline v0 {
namespace {

/// integer_rows() of one v.
using Rows = std::vector<IntegerPolynomial>;

/// ⌈log₂ x⌉ for x ≥ 1.
long log2_above(long x) { return bit_length(Integer(x - 1)); }

/// The bits of a bound for ‖f‖₁ ≤ √(length)·‖f‖₂.
long sum_bits(const IntegerPolynomial& f) {
  return norm_bits(f) + (log2_above(std::max(1L, fmpz_poly_length(f.get()))) + 1) / 2;
}

/// The bits that P must have more than.
long bits_of_proof(const Rows& v, const IntegerFraction& f, const std::vector<Factor>& factors) {
  long degree = 0;
  long bits = 0;
  for (const IntegerPolynomial& row : v) {
    degree = std::max(degree, fmpz_poly_degree(row.get()));
    bits = std::max(bits, sum_bits(row));
  }
  bits += log2_above(static_cast<long>(v.size()));
  // ‖d′‖₁ ≤ N·‖d‖₁.
  const long n = fmpz_poly_degree(f.denominator.get());
  bits += degree * std::max(sum_bits(f.numerator),
                            sum_bits(f.denominator) + log2_above(n) + bit_length(f.scale));
  const long degree_of_h = degree * (n - 1) + static_cast<long>(v.size()) - 1;
  long of_factors = 0;
  for (const Factor& e : factors)
    of_factors = std::max(
        of_factors, degree_of_h * norm_bits(integer_primitive_part(e.base)) / e.base.degree() + 1);
  return bits + of_factors;
}

/// Are all v(c, t) = 0 in 𝔽ₚ[t]/(d)?
bool vanish_modulo(const std::vector<Rows>& list, const ModularAlgebra& algebra,
                   const ModularPolynomial& c) {
  std::vector<ModularPolynomial> rows;
  for (const Rows& v : list)
    for (const IntegerPolynomial& row : v) rows.emplace_back(algebra.prime(), row);
  const std::vector<ModularPolynomial> values = values_at(algebra, rows, c);
  const ModularPolynomial t = algebra.variable();
  auto end = values.begin();
  return std::all_of(list.begin(), list.end(), [&](const Rows& v) {
    auto at = end += static_cast<long>(v.size());
    ModularPolynomial sum(algebra.prime());
    for (std::size_t k = 0; k < v.size(); ++k) {
      if (k > 0) sum = algebra.multiply(sum, t);
      sum += *--at;
    }
    return sum.is_zero();
  });
}

}  // namespace

bool vanish_at_residues(const std::vector<Bivariate>& list, const Polynomial& n,
                        const Polynomial& d) {
  const IntegerFraction f = integer_fraction(n, d);
  std::vector<Rows> rows;
  for (const Bivariate& v : list)
    if (!v.is_zero()) rows.push_back(integer_rows(v));
  if (rows.empty()) return true;
  long bits = 0;  // not known before the first prime has not denied it
  Primes primes;
  for (long proved = 0; bits == 0 || proved <= bits;) {
    const Word p = primes.next();
    const auto algebra = ModularAlgebra::make(ModularPolynomial(p, f.denominator), d.degree());
    const Word s = residue(f.scale, p);
    if (!algebra || s == 0) continue;
    ModularPolynomial c = algebra->residue(ModularPolynomial(p, f.numerator));
    c /= s;
    if (!vanish_modulo(rows, *algebra, c)) return false;
    proved += 61;  // p > 2⁶¹
    if (bits > 0) continue;
    const std::vector<Factor> factors = factor(d).factors;
    for (const Rows& v : rows) bits = std::max(bits, bits_of_proof(v, f, factors));
  }
  return true;
}

}  // namespace phrame
