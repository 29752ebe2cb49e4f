// The derivative of Σ c(α) log v(α, t), v made monic, with d = deg v, e = deg q, n = d·e:
//
//   v_t/v = Σ_{k≥0} s_k t^{−k−1},  s_k ∈ ℚ[x]/(q) the power sums of the roots of v in t (s₀ = d),
//
// so the derivative is Σ Tr(c·s_k) t^{−k−1}. Its denominator is the norm of v, monic of degree n,
// whose own power sums are Tr(s_k); with z = 1/t its reversed polynomial is exp(−Σ Tr(s_k) zᵏ/k).
// The reversed numerator is that times Σ Tr(c·s_k) zᵏ modulo zⁿ.
//
// For v = t − x the sum Σ c(z)/(t − z) has the denominator q, and the numerator is the polynomial
// of degree < e with the value c(z)·q′(z) at every root z (Lagrange): c·q′ mod q.
#include "phrame/integrate/antiderivative.hpp"

#include "phrame/algebra/power_series.hpp"
#include "phrame/integrate/residue_derivative.hpp"

namespace phrame::inline v0 {
namespace {

RationalFunction derivative_by_power_sums(const LogSum& sum) {
  const QuotientRing ring(sum.index);
  const long d = sum.argument.degree();
  const long n = d * ring.modulus().degree();
  const Polynomial lead = sum.argument.coefficient(d);
  std::vector<Polynomial> c;
  for (long k = d - 1; k >= 0; --k) c.push_back(ring.divide(sum.argument.coefficient(k), lead));
  const auto s = power_sums(
      c, n, [&](const Polynomial& a, const Polynomial& b) { return ring.multiply(a, b); });

  std::vector<Rational> logarithm{0};  // −Tr(s_k)/k
  std::vector<Rational> weighted{d * ring.trace(sum.residue)};
  for (long k = 1; k <= n; ++k) {
    const Polynomial& s_k = s[static_cast<std::size_t>(k - 1)];
    logarithm.push_back(ring.trace(s_k) / -k);
    weighted.push_back(ring.trace(sum.residue * s_k));
  }
  const Polynomial norm = exp_series(Polynomial(logarithm), n + 1);
  const Polynomial numerator = truncated(norm * Polynomial(weighted), n);
  return {reversed(numerator, n), reversed(norm, n + 1)};
}

/// The same for deg q = 2, without power sums: with v = A + xB, x + x̄ = s and x·x̄ = r, the norm is
/// v·v̄ = A² + sAB + rB², and v_t·v̄ = u + xw; the numerator is Tr(c·(u + xw)).
RationalFunction derivative_over_quadratic(const LogSum& sum) {
  const Rational lead = sum.index.coefficient(2);
  const Rational s = -sum.index.coefficient(1) / lead;
  const Rational r = sum.index.coefficient(0) / lead;
  std::vector<Rational> constant_terms;
  std::vector<Rational> linear_terms;
  for (const Polynomial& c : sum.argument.coefficients()) {
    constant_terms.push_back(c.coefficient(0));
    linear_terms.push_back(c.coefficient(1));
  }
  const Polynomial a(constant_terms);
  const Polynomial b(linear_terms);
  const Polynomial da = differentiate(a);
  const Polynomial db = differentiate(b);
  const Polynomial u = da * a + s * (da * b) + r * (db * b);
  const Polynomial w = db * a - da * b;
  const Rational c0 = sum.residue.coefficient(0);
  const Rational c1 = sum.residue.coefficient(1);
  // Tr(1) = 2, Tr(x) = s, Tr(x²) = s² − 2r.
  return {Rational(2 * c0 + s * c1) * u + Rational(s * c0 + (s * s - 2 * r) * c1) * w,
          a * a + s * (a * b) + r * (b * b)};
}

/// The same for deg q = 1: c·v′/v.
RationalFunction derivative_over_rational(const LogSum& sum) {
  const QuotientRing ring(sum.index);
  const Bivariate argument = ring.reduce(sum.argument);
  std::vector<Rational> v;
  for (const Polynomial& c : argument.coefficients()) v.push_back(c.coefficient(0));
  const Rational c = ring.reduce(sum.residue).coefficient(0);
  return {c * differentiate(Polynomial(v)), Polynomial(v)};
}

}  // namespace

bool is_over_poles(const LogSum& sum) {
  static const Bivariate t_minus_x({Polynomial{0, -1}, Polynomial{1}});
  return sum.argument == t_minus_x ||
         (sum.index.degree() == 1 && sum.argument == QuotientRing(sum.index).reduce(t_minus_x));
}

RationalFunction differentiate(const LogSum& sum) {
  // Σ n(z)/d′(z) · 1/(t − z) = n/d: of the residue n/d′ mod d, which is long, n comes back.
  if (is_over_poles(sum))
    return {short_remainder(sum.residue * differentiate(sum.index), sum.index), sum.index};
  if (sum.index.degree() == 1) return derivative_over_rational(sum);
  if (sum.index.degree() == 2) return derivative_over_quadratic(sum);
  if (auto derivative = derivative_over_residues(sum)) return *std::move(derivative);
  return derivative_by_power_sums(sum);
}

RationalFunction differentiate(const Antiderivative& F) {
  RationalFunction result =
      RationalFunction(differentiate(F.polynomial)) + differentiate(F.rational);
  for (const LogSum& sum : F.logs) result = result + differentiate(sum);
  return result;
}

Rational difference_without_logarithms(const Antiderivative& F, const Rational& a,
                                       const Rational& b) {
  return F.polynomial(b) - F.polynomial(a) + F.rational(b) - F.rational(a);
}

}  // namespace phrame
