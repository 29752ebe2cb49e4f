// Conjugate residues α, ᾱ with the argument v(α, t) = P + iQ of the logarithm give, for α = p + iq,
//   α log(P + iQ) + ᾱ log(P − iQ) = p·log(P² + Q²) − 2q·arg(P + iQ),
// and −2·arg(A + iB) is, up to a constant, a sum of arctangents of polynomials [Rioboo 1991;
// Bronstein 2005, §2.8]: 2·arctan(A/B) where B divides A; else, with B·D − A·C = G = gcd(A, B),
// 2·arctan((A·D + B·C)/G) plus the same for D + iC, of lower degree. For residues in ℚ(√−d) the
// pairs are (P, √d·Q) with P, Q ∈ ℚ[t]: multiplied by √d where needed they keep this shape, and
// every arctangent is that of √d times a rational polynomial.
#include "phrame/integrate/real_form.hpp"

#include <algorithm>
#include <map>

#include "phrame/algebra/error.hpp"
#include "phrame/algebra/real_algebraic.hpp"
#include "phrame/integrate/lazard_rioboo_trager.hpp"

namespace phrame {
namespace {

Surd surd(const Rational& a, const Rational& b, const Integer& d) {
  return b == 0 || d == 1 ? Surd{a + b, 0, 1} : Surd{a, b, d};
}

SurdPolynomial surd_polynomial(const Polynomial& a, const Polynomial& b, const Integer& d) {
  return b.is_zero() || d == 1 ? SurdPolynomial{a + b, {}, 1} : SurdPolynomial{a, b, d};
}

Polynomial norm(const SurdPolynomial& v) { return v.a * v.a - Rational(v.d) * (v.b * v.b); }

/// Has v a real zero? At a real root of a² − d·b² it is a zero of a + b√d where a·b ≤ 0.
bool has_real_zero(const SurdPolynomial& v) {
  if (v.b.is_zero()) return count_real_roots(v.a, real_line()) > 0;
  const Polynomial product = v.a * v.b;
  const std::vector<RealRoot> roots = real_roots(norm(v), real_line());
  return std::any_of(roots.begin(), roots.end(),
                     [&](const RealRoot& root) { return sign_at(product, root.at) <= 0; });
}

struct ExtendedGcd {
  Polynomial g;
  Polynomial s;
  Polynomial t;
};

/// g = s·a + t·b, monic.
ExtendedGcd extended_gcd(const Polynomial& a, const Polynomial& b) {
  ExtendedGcd result;
  fmpq_poly_xgcd(result.g.raw(), result.s.raw(), result.t.raw(), a.raw(), b.raw());
  return result;
}

/// −2·factor·√d·arg(P + i√d·Q) as arctangents; deg P ≥ deg Q ≥ 0. That remains so: the next pair is
/// (D, C), and A·C = B·D − G has no higher degree than B·D.
void add_arctangents(RealForm& form, const Rational& factor, const Integer& d, Polynomial p,
                     Polynomial q) {
  const auto add = [&](const Polynomial& w) {  // 2·factor·√d·arctan(√d·w)
    if (w.is_constant()) return;
    const Rational sign = w.leading_coefficient() < 0 ? -1 : 1;
    form.arctangents.push_back({surd(0, 2 * sign * factor, d), surd_polynomial({}, sign * w, d)});
  };
  while (true) {
    const Division division = divide(p, q);
    if (division.remainder.is_zero()) return add(Rational(1, d) * division.quotient);
    const ExtendedGcd e = extended_gcd(q, -p);
    add(exact_quotient(Rational(1, d) * (p * e.s) + q * e.t, e.g));
    p = e.s;
    q = e.t;
  }
}

void add_logarithm(RealForm& form, const Surd& factor, const SurdPolynomial& of) {
  form.logarithms.push_back({factor, of, !has_real_zero(of)});
}

/// Σ x·log v(x, t) over the roots of an irreducible polynomial of degree ≤ 2.
void add_quadratic(RealForm& form, const LogSum& sum) {
  const Surd alpha = quadratic_root(sum.index);
  std::vector<Rational> constant;
  std::vector<Rational> linear;
  for (const Polynomial& c : sum.argument.coefficients()) {
    constant.push_back(c.coefficient(0) + alpha.a * c.coefficient(1));
    linear.push_back(alpha.b * c.coefficient(1));
  }
  const Polynomial p(constant);
  const Polynomial q(linear);
  if (alpha.d > 0) {
    add_logarithm(form, alpha, surd_polynomial(p, q, alpha.d));
    if (alpha.d != 1)
      add_logarithm(form, {alpha.a, -alpha.b, alpha.d}, surd_polynomial(p, -q, alpha.d));
    return;
  }
  const Integer d = -alpha.d;
  if (alpha.a != 0) add_logarithm(form, {alpha.a, 0, 1}, {p * p + Rational(d) * (q * q), {}, 1});
  add_arctangents(form, alpha.b, d, p, q);
}

}  // namespace

RealForm real_form(const Antiderivative& F) {
  RealForm form;
  form.polynomial = F.polynomial;
  form.rational = F.rational;
  const RationalFunction simple = differentiate(Antiderivative{{}, {}, F.logs});
  const RationalFunction algebraic = differentiate(Antiderivative{F.polynomial, F.rational, {}});
  std::vector<SimpleFraction> quadratic;
  for (const SimpleFraction& f : simple_fractions(simple)) {
    if (has_quadratic_residues(f))
      quadratic.push_back(f);
    else
      form.others.push_back(full_partial_fraction(f));
  }
  for (const LogSum& sum : over_residues(quadratic)) add_quadratic(form, sum);
  if (!(differentiate(form) == algebraic + simple))
    throw Error("real_form: the check failed, the derivative has changed");
  return form;
}

RationalFunction differentiate(const RealForm& form) {
  RationalFunction result =
      RationalFunction(differentiate(form.polynomial)) + differentiate(form.rational);
  std::map<Integer, RationalFunction> irrational;  // what is to be multiplied by √d
  for (const auto& [factor, of, positive] : form.logarithms) {
    // (p + q√d)(a′ + b′√d)/(a + b√d), the fraction expanded by a − b√d.
    const Polynomial n = norm(of);
    const Rational d(of.d);
    const Polynomial da = differentiate(of.a);
    const Polynomial db = differentiate(of.b);
    const Polynomial x = da * of.a - d * (db * of.b);
    const Polynomial y = db * of.a - da * of.b;
    result = result + RationalFunction(factor.a * x + (factor.b * d) * y, n);
    RationalFunction& rest = irrational[of.d];
    rest = rest + RationalFunction(factor.a * y + factor.b * x, n);
  }
  for (const auto& [factor, of] : form.arctangents) {
    // √d·q·arctan(√d·w) or, for d = 1, q·arctan(w).
    const Rational d(of.d);
    const Polynomial& w = of.d == 1 ? of.a : of.b;
    const Rational& q = of.d == 1 ? factor.a : factor.b;
    result = result + RationalFunction(q * d * differentiate(w), Polynomial{1} + d * (w * w));
  }
  for (const auto& [d, rest] : irrational)
    if (!rest.is_zero()) throw Error("real form: the derivative is not rational");
  for (const LogSum& sum : form.others) result = result + differentiate(sum);
  return result;
}

}  // namespace phrame
