// Conjugate residues α, ᾱ with the argument v(α, t) = P + iQ of the logarithm give, for α = p + iq,
//   α log(P + iQ) + ᾱ log(P − iQ) = p·log(P² + Q²) − 2q·arg(P + iQ),
// and −2·arg(A + iB) is, up to a constant, a sum of arctangents of polynomials [Rioboo 1991;
// Bronstein 2005, §2.8]: 2·arctan(A/B) where B divides A; else, with B·D − A·C = G = gcd(A, B),
// 2·arctan((A·D + B·C)/G) plus the same for D + iC, of lower degree. For residues in ℚ(√−d) the
// pairs are (P, √d·Q) with P, Q ∈ ℚ[t]: multiplied by √d where needed they keep this shape, and
// every arctangent is that of √d times a rational polynomial. Equal residues of different fractions
// are not put into one arctangent: arctan(t) + arctan(t + 1) is shorter.
//
// Over a real quadratic field, with w = t + p/2 and h = q − p²/4,
//   ∫ (αt + β)/(t² + pt + q) = (α/2)·log|w² + h| + (β − αp/2)·∫ dt/(w² + h),
//   ∫ dt/(w² + h) = arctan(w/√h)/√h for h > 0,  log|(w − √−h)/(w + √−h)|/(2√−h) for h < 0.
#include "phrame/integrate/real_form.hpp"

#include <algorithm>
#include <map>

#include "phrame/algebra/error.hpp"
#include "phrame/algebra/real_algebraic.hpp"
#include "phrame/integrate/integrate.hpp"
#include "phrame/integrate/other_form.hpp"
#include "phrame/integrate/quadratic_fields.hpp"
#include "phrame/integrate/rothstein_trager.hpp"

namespace phrame::inline v0 {
namespace {

/// Has a + b√d a real zero? At a real root of a² − d·b² it has one where a·b ≤ 0.
bool has_real_zero(const Polynomial& a, const Polynomial& b, const Integer& d) {
  if (b.is_zero()) return count_real_roots(a, real_line()) > 0;
  const Polynomial product = a * b;
  const std::vector<RealRoot> roots = real_roots(a * a - Rational(d) * (b * b), real_line());
  return std::any_of(roots.begin(), roots.end(),
                     [&](const RealRoot& root) { return sign_at(product, root.at) <= 0; });
}

/// −2·factor·√d·arg(P + i√d·Q) as arctangents; deg P ≥ deg Q ≥ 0. That remains so: the next pair is
/// (D, C), and A·C = B·D − G has no higher degree than B·D.
void add_arctangents(RealForm& form, const Rational& factor, const Integer& d, Polynomial p,
                     Polynomial q) {
  const auto add = [&](const Polynomial& w) {  // 2·factor·√d·arctan(√d·w)
    if (w.is_constant()) return;
    const Rational sign = w.leading_coefficient() < 0 ? -1 : 1;
    form.arctangents.push_back({Surd(0, 2 * sign * factor, d), SurdPolynomial({}, sign * w, d)});
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

/// factor·log|a + b√d|.
void add_logarithm(RealForm& form, const Surd& factor, const Polynomial& a,
                   const Polynomial& b = {}, const Integer& d = 1) {
  form.logarithms.push_back({factor, SurdPolynomial(a, b, d), !has_real_zero(a, b, d)});
}

/// Σ x·log v(x, t) over the roots of an irreducible polynomial of degree ≤ 2; no value where that
/// is too long for a textbook.
std::optional<RealForm> over_quadratic(const LogSum& sum, Style style) {
  constexpr long most_poles = 3;
  RealForm form;
  const QuadraticNumber alpha = quadratic_root(sum.index);
  std::vector<Rational> constant;
  std::vector<Rational> linear;
  for (const Polynomial& c : sum.argument.coefficients()) {
    constant.push_back(c.coefficient(0) + alpha.a * c.coefficient(1));
    linear.push_back(alpha.b * c.coefficient(1));
  }
  const Polynomial p(constant);
  const Polynomial q(linear);
  if (alpha.d > 0) {
    add_logarithm(form, {alpha.a, alpha.b, alpha.d}, p, q, alpha.d);
    if (alpha.d != 1) add_logarithm(form, {alpha.a, -alpha.b, alpha.d}, p, -q, alpha.d);
    return form;
  }
  if (style == Style::textbook && p.degree() > most_poles && !(p % q).is_zero())
    return std::nullopt;  // several arctangents
  const Integer d = -alpha.d;
  if (alpha.a != 0) add_logarithm(form, alpha.a, p * p + Rational(d) * (q * q));
  add_arctangents(form, alpha.b, d, p, q);
  return form;
}

void add_integral(RealForm& form, const QuadraticFraction& f) {
  const Surd middle = Rational(1, 2) * f.p;
  const Surd h = f.q - middle * middle;
  const bool is_positive = sign(h) > 0;
  if (!f.alpha.is_zero())
    form.logarithms.push_back(
        {Rational(1, 2) * f.alpha, surd_polynomial({f.q, f.p, Rational(1)}), is_positive});
  const Surd rest = f.beta - f.alpha * middle;
  if (rest.is_zero()) return;
  if (is_positive)
    form.arctangents.push_back({rest / h, surd_polynomial({middle / h, Surd(1) / h}), h});
  else
    form.quotients.push_back(
        {Rational(-1, 2) * (rest / h), surd_polynomial({middle, Rational(1)}), -h});
}

RealForm integral_of(const std::vector<QuadraticFraction>& fractions) {
  RealForm form;
  for (const QuadraticFraction& f : fractions) add_integral(form, f);
  return form;
}

template <class T>
void append(std::vector<T>& list, const std::vector<T>& more) {
  list.insert(list.end(), more.begin(), more.end());
}

void append(RealForm& form, const RealForm& more) {
  append(form.logarithms, more.logarithms);
  append(form.arctangents, more.arctangents);
  append(form.quotients, more.quotients);
}

bool is_short(const Surd& x) {
  constexpr std::size_t most_digits = 40;
  std::size_t longest = 0;
  for (const auto& [d, c] : x.terms()) longest = std::max(longest, to_string(c).size());
  return x.is_zero() || longest + x.terms().rbegin()->first.str().size() <= most_digits;
}

bool is_short(const SurdPolynomial& p) {
  for (long k = degree(p); k >= 0; --k)
    if (!is_short(coefficient(p, k))) return false;
  return true;
}

/// Does it fit into a line of a book?
bool is_short(const RealForm& form) {
  return std::all_of(form.logarithms.begin(), form.logarithms.end(),
                     [](const auto& x) { return is_short(x.factor); }) &&
         std::all_of(form.arctangents.begin(), form.arctangents.end(),
                     [](const auto& x) {
                       return is_short(x.factor) && is_short(x.of) && is_short(x.radicand);
                     }) &&
         std::all_of(form.quotients.begin(), form.quotients.end(), [](const auto& x) {
           return is_short(x.factor) && is_short(x.of) && is_short(x.radicand);
         });
}

/// The form of one fraction; no value where it is a sum over roots.
std::optional<RealForm> form_of(const SimpleFraction& f, Style style) {
  std::optional<RealForm> form;
  if (has_residues_of_degree_at_most(f, 2)) {
    form = over_quadratic(over_residues({f}).front(), style);
    // Rational coefficients are better than linear arguments.
    const bool is_irrational =
        form && form->arctangents.size() > 1 && !form->arctangents.front().of.is_rational();
    if (form && !is_irrational) return form;
  }
  const auto fractions = over_real_quadratic_fields(f);
  return fractions.empty() ? form : integral_of(fractions);
}

struct Parts {
  RealForm form;
  std::vector<SimpleFraction> others;
};

Parts parts_of(const Antiderivative& F, Style style) {
  Parts parts{{F.polynomial, F.rational, {}, {}}, {}};
  std::vector<LogSum> rational;  // equal rational residues are put into one logarithm
  RealForm irrational;
  for (const SimpleFraction& f : simple_fractions(differentiate(Antiderivative{{}, {}, F.logs}))) {
    const auto part = form_of(f, style);
    if (!part || (style == Style::textbook && !is_short(*part)))
      parts.others.push_back(f);
    else if (part->logarithms.size() == 1 && part->logarithms.front().of.is_rational() &&
             part->arctangents.empty())
      rational.push_back(over_residues({f}).front());
    else
      append(irrational, *part);
  }
  for (const LogSum& sum : merge_equal_residues(std::move(rational)))
    append(parts.form, *over_quadratic(sum, Style::real));
  append(parts.form, irrational);
  return parts;
}

void check(const RationalFunction& derivative, const Antiderivative& F) {
  if (!(derivative == differentiate(F)))
    throw Error("real_form: the check failed, the derivative has changed");
}

}  // namespace

RealForm real_form(const Antiderivative& F) {
  auto [form, others] = parts_of(F, Style::real);
  for (const SimpleFraction& f : others) form.others.push_back(full_partial_fraction(f));
  check(differentiate(form), F);
  return form;
}

TextbookForm textbook_form(const Antiderivative& F) {
  const auto [form, others] = parts_of(F, Style::textbook);
  RationalFunction rest;
  for (const auto& [n, d] : others) rest = rest + RationalFunction(n, d);
  TextbookForm result{form, integrate(rest).logs};
  check(differentiate(form) + differentiate(Antiderivative{{}, {}, result.sums}), F);
  return result;
}

std::vector<LogSum> sums_over_poles(const TextbookForm& F) {
  std::vector<LogSum> sums;
  const RationalFunction rest = differentiate(Antiderivative{{}, {}, F.sums});
  for (const SimpleFraction& f : simple_fractions(rest)) sums.push_back(full_partial_fraction(f));
  return sums;
}

RationalFunction differentiate(const RealForm& form) {
  RationalFunction result =
      RationalFunction(differentiate(form.polynomial)) + differentiate(form.rational);
  SurdPolynomial numerators;  // of what has roots, over the denominator
  Polynomial denominator{1};
  const auto add = [&](SurdPolynomial n, SurdPolynomial d) {
    while (!d.is_rational()) {
      const SurdPolynomial other = conjugate(d, half_field(d));
      n = n * other;
      d = d * other;
    }
    const Polynomial rational = d.rational_part();
    if (n.is_rational()) {
      result = result + RationalFunction(n.rational_part(), rational);
      return;
    }
    const Polynomial common = gcd(denominator, rational);
    const Polynomial to_old = exact_quotient(rational, common);
    const Polynomial to_new = exact_quotient(denominator, common);
    numerators = SurdPolynomial(to_old) * numerators + SurdPolynomial(to_new) * n;
    denominator *= to_old;
  };
  const SurdPolynomial one(Polynomial{1});
  for (const auto& [factor, of, positive] : form.logarithms) add(factor * differentiate(of), of);
  for (const auto& [factor, of, radicand] : form.arctangents)
    add(factor * radicand * differentiate(of), one + radicand * (of * of));
  for (const auto& [factor, of, radicand] : form.quotients)
    add(Rational(2) * factor * radicand * differentiate(of), of * of - radicand * one);
  if (!numerators.is_rational()) throw Error("real form: the derivative is not rational");
  result = result + RationalFunction(numerators.rational_part(), denominator);
  for (const LogSum& sum : form.others) result = result + differentiate(sum);
  return result;
}

}  // namespace phrame
