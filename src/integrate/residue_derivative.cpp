// Modulo p, with the power sums s_i ∈ 𝔽ₚ[x]/(q) of the zeros of v(x, t) in t, by Newton's
// identities,
//   Σ α·v_t/v = Σ_i Tr(x·s_i)·t^{−i−1} = n/d,
// where d = ∏ v(α, t)/lead(v(α, t)) has the power sums Tr(s_i). n and d are lifted to ℚ as soon as
// a prime confirms them, and proved by this: let N = deg d = deg q·deg_t v, d squarefree, and
//   q(c(z)) = 0 and v(c(z), z) = 0  at all roots z of d,  c = n/d′.
// Then each of the N different z is a zero of v(α, t) for the α = c(z), which are deg q numbers
// with no more than deg_t v zeros each: so each v(α, t) has as many, the simple roots z of d with
// c(z) = α, and
//   Σ_α α·v_t/v = Σ_α Σ_{c(z)=α} α/(t − z) = Σ_z c(z)/(t − z) = n/d.
#include "phrame/integrate/residue_derivative.hpp"

#include "phrame/algebra/modular_algebra.hpp"
#include "phrame/algebra/rational_lift.hpp"
#include "phrame/algebra/residue_identity.hpp"
#include "phrame/integrate/log_argument.hpp"

namespace phrame::inline v0 {
namespace {

/// s₀, …, s_count from s₀ = k, s_i = −i·c_i − Σ_{0<j<i} c_j·s_{i−j} for v = lead(v)·(tᵏ + c₁tᵏ⁻¹ +
/// …); no value where lead(v) is 0 at a root of q modulo p. The rows are the coefficients of v.
std::optional<std::vector<ModularPolynomial>> power_sums_modulo(const ModularAlgebra& algebra,
                                                                std::vector<ModularPolynomial> rows,
                                                                long count) {
  if (rows.back().is_zero()) return std::nullopt;
  const auto lead = modular_inverse(rows.back(), algebra.modulus());
  if (!lead) return std::nullopt;
  const std::size_t k = rows.size() - 1;
  std::vector<ModularPolynomial> c;  // c[j − 1] = c_j
  for (std::size_t j = 1; j <= k; ++j) c.push_back(algebra.multiply(rows[k - j], lead->inverse));
  std::vector<ModularPolynomial> s = {ModularPolynomial(algebra.prime(), std::vector<Word>{k})};
  for (std::size_t i = 1; i <= static_cast<std::size_t>(count); ++i) {
    ModularPolynomial sum(algebra.prime());
    if (i <= k) {
      sum -= c[i - 1];
      sum *= i;
    }
    for (std::size_t j = 1; j < i && j <= k; ++j) sum -= algebra.multiply(c[j - 1], s[i - j]);
    s.push_back(std::move(sum));
  }
  return s;
}

/// The coefficients of n and of d without its leading one, which is 1; no value where p is bad.
std::optional<std::vector<Word>> derivative_modulo(Word p, const IntegerPolynomial& q,
                                                   const std::vector<IntegerPolynomial>& v,
                                                   long degree) {
  const auto algebra = ModularAlgebra::make(ModularPolynomial(p, q), degree);
  if (!algebra) return std::nullopt;
  std::vector<ModularPolynomial> rows;
  for (const IntegerPolynomial& row : v) {
    rows.emplace_back(p, row);
    reduce(rows.back(), algebra->modulus());
  }
  const long k = static_cast<long>(v.size()) - 1;
  const auto s = power_sums_modulo(*algebra, std::move(rows), k * degree);
  if (!s) return std::nullopt;
  const ModularPolynomial trace = algebra->trace();
  const ModularPolynomial trace_times_x = algebra->compose(trace, algebra->variable());
  std::vector<Word> traces;
  std::vector<Word> weighted;
  for (std::size_t i = 0; i < s->size(); ++i) {
    if (i > 0) traces.push_back(value_of(trace, (*s)[i]));
    if (i + 1 < s->size()) weighted.push_back(value_of(trace_times_x, (*s)[i]));
  }
  const ModularPolynomial d = from_power_sums(p, traces);
  const ModularPolynomial n = numerator_of_series(std::move(weighted), d);
  std::vector<Word> list;
  for (const ModularPolynomial* f : {&n, &d})
    for (long i = 0; i < k * degree; ++i) list.push_back(f->coefficient(i));
  return list;
}

}  // namespace

std::optional<RationalFunction> derivative_over_residues(const LogSum& sum) {
  if (!(sum.residue == Polynomial{0, 1})) return std::nullopt;
  if (const auto composed = as_composed(sum.argument)) {  // F(h)′ = F′(h)·h′
    const auto& [outer, h] = *composed;
    const auto slope = derivative_over_residues({sum.index, sum.residue, outer});
    if (!slope) return std::nullopt;
    return RationalFunction(compose(slope->numerator(), h) * differentiate(h),
                            compose(slope->denominator(), h));
  }
  const long degree = sum.index.degree();
  const auto size = static_cast<std::size_t>(degree * sum.argument.degree());
  const IntegerPolynomial q = integer_primitive_part(sum.index);
  const std::vector<IntegerPolynomial> v = integer_rows(sum.argument);
  RationalLift lift(2 * size);
  std::optional<std::vector<Rational>> numbers;
  for (Primes primes; !numbers;) {
    const Word p = primes.next();
    if (const auto image = derivative_modulo(p, q, v, degree))
      numbers = lift.include(*image, p);
    else if (!is_squarefree(sum.index) ||
             !gcd(sum.argument.coefficient(sum.argument.degree()), sum.index).is_constant())
      return std::nullopt;
  }
  const auto middle = numbers->begin() + static_cast<long>(size);
  std::vector<Rational> d(middle, numbers->end());
  d.emplace_back(1);
  const RationalFunction f(Polynomial(std::vector(numbers->begin(), middle)), Polynomial(d));
  if (f.denominator().degree() != static_cast<long>(size)) return std::nullopt;
  if (!is_squarefree(f.denominator())) return std::nullopt;
  const Bivariate index({sum.index});
  if (!vanish_at_residues({index, sum.argument}, f.numerator(), f.denominator()))
    return std::nullopt;
  return f;
}

}  // namespace phrame
