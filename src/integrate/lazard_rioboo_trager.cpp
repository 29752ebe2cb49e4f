// The subresultants are not computed from their definition but from the poles they vanish at. With
// c = n/d′ in 𝔽ₚ[t]/(d) and Q = ∏ Q_k of degree M, the power sums p_j(α) = Σ_{c(z)=α} zʲ are
// interpolated by traces:
//   Σ_α p_j(α)/(x − α) = Σ_i Tr(tʲ·cⁱ)·x^{−i−1} = P_j(x)/Q(x),   so p_j(α) = P_j(α)/Q′(α),
// where M traces are a power projection, about 2√M products modulo d. Newton's identities in
// 𝔽ₚ[x]/(Q_k) make v_k from p_1, …, p_k.
#include "phrame/integrate/lazard_rioboo_trager.hpp"

#include <algorithm>

#include "phrame/algebra/error.hpp"
#include "phrame/algebra/factor.hpp"
#include "phrame/algebra/modular_algebra.hpp"
#include "phrame/algebra/rational_lift.hpp"
#include "phrame/algebra/resultant.hpp"
#include "phrame/integrate/rothstein_trager.hpp"

namespace phrame {
namespace {

/// P_1, …, P_count.
std::vector<ModularPolynomial> interpolated_power_sums(const ModularAlgebra& algebra,
                                                       const ModularPolynomial& c,
                                                       const ModularPolynomial& q, long count) {
  const long m = q.degree();
  const ModularPolynomial t = algebra.variable();
  ModularPolynomial form = algebra.trace();
  std::vector<ModularPolynomial> result;
  for (long j = 1; j <= count; ++j) {
    form = algebra.compose(form, t);
    std::vector<Word> traces = values_of_powers(algebra, form, c, m);
    std::reverse(traces.begin(), traces.end());
    ModularPolynomial p(algebra.prime(), traces);
    p *= q;
    result.push_back(shifted_down(p, m));
  }
  return result;
}

/// The coefficients of t⁰, …, tᵏ⁻¹ of v = tᵏ + c₁tᵏ⁻¹ + … from j·c_j = −Σ_{0<i≤j} c_{j−i}·p_i,
/// flattened, deg Q_k numbers each.
std::vector<Word> monic_argument(const std::vector<ModularPolynomial>& sums,
                                 const ModularPolynomial& slope_inverse,
                                 const ModularPolynomial& q_k, long k) {
  const Word prime = q_k.prime();
  const auto multiply = [&](const ModularPolynomial& a, const ModularPolynomial& b) {
    return multiply_modulo(a, b, q_k);
  };
  std::vector<ModularPolynomial> p;
  for (long j = 0; j < k; ++j) {
    ModularPolynomial reduced = sums[static_cast<std::size_t>(j)];
    reduce(reduced, q_k);
    p.push_back(multiply(reduced, slope_inverse));
  }
  std::vector<ModularPolynomial> c = {ModularPolynomial(prime, std::vector<Word>{1})};
  for (std::size_t j = 1; j <= static_cast<std::size_t>(k); ++j) {
    ModularPolynomial sum(prime);
    for (std::size_t i = 1; i <= j; ++i) sum -= j == i ? p[i - 1] : multiply(c[j - i], p[i - 1]);
    sum /= j;
    c.push_back(std::move(sum));
  }
  std::vector<Word> list;
  for (std::size_t j = static_cast<std::size_t>(k); j >= 1; --j)
    for (long i = 0; i < q_k.degree(); ++i) list.push_back(c[j].coefficient(i));
  return list;
}

/// numerator/(scale·denominator).
struct IntegerFraction {
  IntegerPolynomial numerator;
  Integer scale;
  IntegerPolynomial denominator;
  long poles;  ///< the degree of the denominator
};

/// The arguments for all factors of the residue polynomial modulo p, flattened one after the other;
/// no value where p is bad.
std::optional<std::vector<Word>> arguments_modulo(Word p, const IntegerFraction& f,
                                                  const std::vector<Factor>& residues) {
  const auto algebra = ModularAlgebra::make(ModularPolynomial(p, f.denominator), f.poles);
  const Word s = residue(f.scale, p);
  if (!algebra || s == 0) return std::nullopt;
  ModularPolynomial c = algebra->residue(ModularPolynomial(p, f.numerator));
  c /= s;

  ModularPolynomial q(p, std::vector<Word>{1});
  std::vector<ModularPolynomial> factors;
  long most_poles = 0;
  for (const auto& [base, exponent] : residues) {
    factors.emplace_back(p, integer_primitive_part(base));
    if (factors.back().degree() != base.degree()) return std::nullopt;
    q *= factors.back();
    most_poles = std::max(most_poles, exponent);
  }
  const ModularPolynomial slope = differentiate(q);
  const auto sums = interpolated_power_sums(*algebra, c, q, most_poles);
  std::vector<Word> all;
  for (std::size_t k = 0; k < factors.size(); ++k) {
    ModularPolynomial reduced = slope;
    reduce(reduced, factors[k]);
    if (reduced.is_zero()) return std::nullopt;
    const auto inverse = modular_inverse(reduced, factors[k]);
    if (!inverse) return std::nullopt;
    const auto list = monic_argument(sums, inverse->inverse, factors[k], residues[k].exponent);
    all.insert(all.end(), list.begin(), list.end());
  }
  return all;
}

}  // namespace

std::vector<LogSum> lazard_rioboo_trager(const RationalFunction& f) {
  if (!f.is_proper()) throw DomainError("lazard_rioboo_trager: the function has a polynomial part");
  if (f.is_zero()) return {};
  return lazard_rioboo_trager(f, residue_polynomial(f.numerator(), f.denominator()));
}

/// The residue polynomial is a power of the irreducible polynomial of one residue.
bool has_quadratic_residues(const SimpleFraction& f) {
  const auto& [n, d] = f;
  if (d.degree() <= 2) return true;
  if (distinct_residues_modulo_a_prime(n, d) > 2) return false;
  return squarefree_part(residue_polynomial(n, d)).degree() <= 2;
}

std::vector<LogSum> over_residues(const std::vector<SimpleFraction>& fractions) {
  std::vector<LogSum> sums;
  for (const auto& [n, d] : fractions) {
    sums.push_back(lazard_rioboo_trager({n, d}).front());
    if (!(differentiate(sums.back()) == RationalFunction(n, d)))
      throw Error("over_residues: the check failed, the derivative is not the fraction");
  }
  return merge_equal_residues(std::move(sums));
}

std::vector<LogSum> lazard_rioboo_trager(const RationalFunction& f,
                                         const Polynomial& residue_polynomial) {
  if (!f.is_proper()) throw DomainError("lazard_rioboo_trager: the function has a polynomial part");
  if (!is_squarefree(f.denominator()))
    throw DomainError("lazard_rioboo_trager: the function has a multiple pole");
  if (residue_polynomial.degree() != f.denominator().degree() || f.is_zero())
    throw DomainError("lazard_rioboo_trager: not the residue polynomial of the function");
  const std::vector<Factor> residues = squarefree_factorization(residue_polynomial).factors;
  const IntegerFraction over_integers{integer_numerator(f.numerator()), denominator(f.numerator()),
                                      integer_primitive_part(f.denominator()),
                                      f.denominator().degree()};

  std::size_t count = 0;
  for (const auto& [base, exponent] : residues)
    count += static_cast<std::size_t>(base.degree() * exponent);
  RationalLift lift(count);
  std::optional<std::vector<Rational>> numbers;
  for (Primes primes; !numbers;) {
    const Word p = primes.next();
    if (const auto image = arguments_modulo(p, over_integers, residues))
      numbers = lift.include(*image, p);
  }
  std::vector<LogSum> sums;
  auto at = numbers->begin();
  for (const auto& [base, exponent] : residues) {
    const auto end = at + base.degree() * exponent;
    sums.push_back({base, QuotientRing(base).reduce(Polynomial{0, 1}),
                    monic_from_rows(std::vector(at, end), base.degree())});
    at = end;
  }
  return sums;
}

}  // namespace phrame
