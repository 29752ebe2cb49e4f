// The subresultants are not computed from their definition but from the poles they vanish at. With
// c = n/d′ in 𝔽ₚ[t]/(d) and Q = ∏ Q_k of degree M, the power sums p_j(α) = Σ_{c(z)=α} zʲ are
// interpolated by traces:
//   Σ_α p_j(α)/(x − α) = Σ_i Tr(tʲ·cⁱ)·x^{−i−1} = P_j(x)/Q(x),   so p_j(α) = P_j(α)/Q′(α),
// where M traces are a power projection, about 2√M products modulo d. Newton's identities in
// 𝔽ₚ[x]/(Q_k) make ∏ (t − z) = tᵏ + c₁tᵏ⁻¹ + … + c_k from p_1, …, p_k.
//
// The coefficients of the c_j ∈ ℚ[x]/(Q_k) have about deg Q_k times as many digits as those of Q_k,
// as they are values at its roots that are interpolated by powers. Interpolated by Lagrange's
// basis they are short [Rouillier 1999]: with m = deg Q_k, Q_k primitive and l = lead(d),
//   N_j = l·Σ_α c_j(α)·Q_k(x)/(x − α) ∈ ℤ[x],  so that N_j(α) = l·Q_k′(α)·c_j(α),
// and with N_0 = l·Q_k′ the argument is v = Σ N_j·tᵏ⁻ʲ, a constant l·Q_k′(α) times ∏ (t − z).
// The coefficients of N_j are integers, since the product of the leading coefficient and of any
// roots of a polynomial over ℤ, each taken as often as it is one, is an algebraic integer: l·c_j(α)
// is a sum of products l·∏ z over different z, the coefficients of Q_k(x)/(x − α) are of products
// lead(Q_k)·∏ β over roots β ≠ α, and so N_j, which is over ℚ, has integral coefficients. With
// Mahler's measure, lead·∏ max(1, |root|) ≤ ‖·‖₂ [Landau 1905], none is greater than
//   m·2^{m−1}·‖Q_k‖₂ · 2ᵏ·‖d‖₂,
// as c_j(α) has no more than 2ᵏ terms, and a coefficient of Q_k(x)/(x − α) no more than 2^{m−1}. So
// their residues modulo primes with a larger product determine them.
#include "phrame/integrate/lazard_rioboo_trager.hpp"

#include <algorithm>
#include <numeric>

#include "phrame/algebra/decomposition.hpp"
#include "phrame/algebra/error.hpp"
#include "phrame/algebra/factor.hpp"
#include "phrame/algebra/hadamard.hpp"
#include "phrame/algebra/integer_fraction.hpp"
#include "phrame/algebra/modular_algebra.hpp"
#include "phrame/algebra/modular_lift.hpp"
#include "phrame/algebra/resultant.hpp"
#include "phrame/integrate/log_argument.hpp"

namespace phrame::inline v0 {
namespace {

/// P_1, …, P_count.
std::vector<ModularPolynomial> interpolated_power_sums(const ModularAlgebra& algebra,
                                                       const ModularPolynomial& c,
                                                       const ModularPolynomial& q, long count) {
  const ModularPolynomial t = algebra.variable();
  ModularPolynomial form = algebra.trace();
  std::vector<ModularPolynomial> result;
  for (long j = 1; j <= count; ++j) {
    form = algebra.compose(form, t);
    result.push_back(numerator_of_series(values_of_powers(algebra, form, c, q.degree()), q));
  }
  return result;
}

/// c_1, …, c_k modulo Q_k from j·c_j = −Σ_{0<i≤j} c_{j−i}·p_i; `slope` is Q′. No value where that
/// has no inverse modulo Q_k.
std::optional<std::vector<ModularPolynomial>> coefficients_modulo(
    const std::vector<ModularPolynomial>& sums, const ModularPolynomial& slope,
    const ModularPolynomial& q_k, std::size_t k) {
  const auto reduced = [&](ModularPolynomial a) {
    reduce(a, q_k);
    return a;
  };
  const ModularPolynomial slope_k = reduced(slope);
  if (slope_k.is_zero()) return std::nullopt;
  const auto inverse = modular_inverse(slope_k, q_k);
  if (!inverse) return std::nullopt;
  std::vector<ModularPolynomial> p;
  for (std::size_t j = 0; j < k; ++j)
    p.push_back(multiply_modulo(reduced(sums[j]), inverse->inverse, q_k));
  std::vector<ModularPolynomial> c;
  for (std::size_t j = 1; j <= k; ++j) {
    ModularPolynomial sum(q_k.prime());
    sum -= p[j - 1];
    for (std::size_t i = 1; i < j; ++i) sum -= multiply_modulo(c[j - i - 1], p[i - 1], q_k);
    sum /= j;
    c.push_back(std::move(sum));
  }
  return c;
}

/// N_k, …, N_1 for each factor Q_k of the residue polynomial, modulo p, one list of coefficients;
/// no value where p is bad. The input is n, d and the factors; n/d is to be divided by `scale`.
std::optional<ModularPolynomial> arguments_modulo(const std::vector<ModularPolynomial>& input,
                                                  const Integer& scale,
                                                  const std::vector<Factor>& residues) {
  const Word p = input[1].prime();
  long poles = 0;
  for (const auto& [q_k, k] : residues) poles += k * q_k.degree();
  const auto algebra = ModularAlgebra::make(input[1], poles);
  const Word s = residue(scale, p);
  if (!algebra || s == 0) return std::nullopt;
  ModularPolynomial c = algebra->residue(input[0]);
  c /= s;
  ModularPolynomial q(p, std::vector<Word>{1});
  long most_poles = 0;
  for (std::size_t i = 0; i < residues.size(); ++i) {
    if (input[i + 2].degree() != residues[i].base.degree()) return std::nullopt;
    q *= input[i + 2];
    most_poles = std::max(most_poles, residues[i].exponent);
  }
  const auto sums = interpolated_power_sums(*algebra, c, q, most_poles);
  std::vector<Word> all;
  for (std::size_t i = 0; i < residues.size(); ++i) {
    const ModularPolynomial& q_k = input[i + 2];
    const auto c_k = coefficients_modulo(sums, differentiate(q), q_k,
                                         static_cast<std::size_t>(residues[i].exponent));
    if (!c_k) return std::nullopt;
    ModularPolynomial n_0 = differentiate(q_k);
    n_0 *= input[1].coefficient(algebra->size());
    for (auto c_j = c_k->rbegin(); c_j != c_k->rend(); ++c_j) {
      const ModularPolynomial n_j = multiply_modulo(*c_j, n_0, q_k);
      for (long x = 0; x < q_k.degree(); ++x) all.push_back(n_j.coefficient(x));
    }
  }
  return ModularPolynomial(p, all);
}

/// The N_j for all factors, as above, lifted to integers.
std::vector<Rational> lifted_arguments(const IntegerFraction& f,
                                       const std::vector<Factor>& residues) {
  std::vector<IntegerPolynomial> inputs = {f.numerator, f.denominator};
  long count = 0;
  long bits = 0;
  for (const auto& [q_k, k] : residues) {
    inputs.push_back(integer_primitive_part(q_k));
    count += q_k.degree() * k;
    bits = std::max(bits, 2 * q_k.degree() + k + norm_bits(inputs.back()));  // m ≤ 2ᵐ
  }
  const IntegerPolynomial lifted =
      modular_lift(inputs, count, bits + norm_bits(f.denominator),
                   [&](const auto& input) { return arguments_modulo(input, f.scale, residues); });
  std::vector<Rational> list = to_polynomial(lifted.get()).coefficients();
  list.resize(static_cast<std::size_t>(count));
  return list;
}

/// One sum for each factor of the residue polynomial of n/d.
std::vector<LogSum> sums_of(const Polynomial& n, const Polynomial& d,
                            const std::vector<Factor>& residues) {
  const std::vector<Rational> numbers = lifted_arguments(integer_fraction(n, d), residues);
  const Rational lead = primitive_part(d).leading_coefficient();
  std::vector<LogSum> sums;
  auto at = numbers.begin();
  for (const auto& [q, k] : residues) {
    const auto end = at + q.degree() * k;
    std::vector<Polynomial> rows = from_rows(std::vector(at, end), q.degree());
    rows.push_back(lead * differentiate(q));
    sums.push_back({q, QuotientRing(q).reduce(Polynomial{0, 1}),
                    short_argument(Bivariate(std::move(rows)), q)});
    at = end;
  }
  return sums;
}

/// Of a fraction of h(t), which has each residue of the outer one deg h times, v(x, h(t)) for the
/// arguments v(x, t) of that.
std::vector<LogSum> composed_sums_of(const Polynomial& n, const Polynomial& d,
                                     std::vector<Factor> residues) {
  long times = 0;
  for (const Factor& factor : residues) times = std::gcd(times, factor.exponent);
  const auto found = widest_decomposition(n, d, times);
  if (!found) return sums_of(n, d, residues);
  const auto& [outer_n, outer_d, inner] = *found;
  for (Factor& factor : residues) factor.exponent /= inner.degree();
  std::vector<LogSum> sums = sums_of(outer_n, outer_d, residues);
  for (LogSum& sum : sums) sum.argument = composed(sum.argument, inner);
  return sums;
}

}  // namespace

std::vector<LogSum> lazard_rioboo_trager(const RationalFunction& f) {
  if (!f.is_proper()) throw DomainError("lazard_rioboo_trager: the function has a polynomial part");
  if (f.is_zero()) return {};
  return lazard_rioboo_trager(f, residue_polynomial(f.numerator(), f.denominator()));
}

std::vector<LogSum> lazard_rioboo_trager(const RationalFunction& f,
                                         const Polynomial& residue_polynomial) {
  if (!f.is_proper()) throw DomainError("lazard_rioboo_trager: the function has a polynomial part");
  if (!is_squarefree(f.denominator()))
    throw DomainError("lazard_rioboo_trager: the function has a multiple pole");
  if (residue_polynomial.degree() != f.denominator().degree() || f.is_zero())
    throw DomainError("lazard_rioboo_trager: not the residue polynomial of the function");
  return composed_sums_of(f.numerator(), f.denominator(),
                          squarefree_factorization(residue_polynomial).factors);
}

}  // namespace phrame
