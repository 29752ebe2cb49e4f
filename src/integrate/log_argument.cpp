// Over ℚ[x]/(q) the leading coefficient has an inverse, and mostly one with numbers of deg q times
// as many digits. So the monic argument is lifted from no more primes than v itself needs: a
// fraction that they tell has a numerator and a denominator of half as many bits.
#include "phrame/integrate/log_argument.hpp"

#include <algorithm>

#include "phrame/algebra/modular.hpp"
#include "phrame/algebra/rational_lift.hpp"

namespace phrame::inline v0 {
namespace {

/// The coefficients of v/lead(v) but the leading one modulo q, deg q numbers each; no value where p
/// is bad.
std::optional<std::vector<Word>> monic_modulo(Word p, const std::vector<IntegerPolynomial>& v,
                                              const IntegerPolynomial& q, long degree) {
  const ModularPolynomial q_p(p, q);
  const ModularPolynomial lead(p, v.back());
  if (q_p.degree() != degree || lead.is_zero()) return std::nullopt;
  const auto inverse = modular_inverse(lead, q_p);
  if (!inverse) return std::nullopt;
  std::vector<Word> list;
  for (std::size_t j = 0; j + 1 < v.size(); ++j) {
    const ModularPolynomial row = multiply_modulo({p, v[j]}, inverse->inverse, q_p);
    for (long i = 0; i < degree; ++i) list.push_back(row.coefficient(i));
  }
  return list;
}

Bivariate with_leading_one(std::vector<Polynomial> rows) {
  rows.push_back(Polynomial{1});
  return Bivariate(std::move(rows));
}

Bivariate divided_by_lead(const Bivariate& v, const Polynomial& q) {
  const QuotientRing ring(q);
  const Polynomial inverse = ring.divide({1}, v.coefficient(v.degree()));
  std::vector<Polynomial> rows;
  for (long j = 0; j < v.degree(); ++j) rows.push_back(ring.multiply(v.coefficient(j), inverse));
  return with_leading_one(std::move(rows));
}

}  // namespace

Bivariate short_argument(const Bivariate& v, const Polynomial& q) {
  if (q.degree() <= 2) return divided_by_lead(v, q);
  const Bivariate primitive = primitive_part(QuotientRing(q).reduce(v));
  const std::vector<IntegerPolynomial> rows = integer_rows(primitive);
  const IntegerPolynomial modulus = integer_primitive_part(q);
  long bits = 0;
  for (const Polynomial& row : primitive.coefficients())
    for (const Rational& c : row.coefficients()) bits = std::max(bits, bit_length(numerator(c)));
  RationalLift lift(static_cast<std::size_t>(v.degree() * q.degree()));
  Primes primes;
  for (long k = 0; k < bits / 61 + 2; ++k) {
    const Word p = primes.next();
    const auto image = monic_modulo(p, rows, modulus, q.degree());
    if (!image) continue;
    if (const auto numbers = lift.include(*image, p))
      return with_leading_one(from_rows(*numbers, q.degree()));
  }
  return primitive;
}

Bivariate composed(const Bivariate& v, const Polynomial& h) {
  std::vector<Polynomial> rows(static_cast<std::size_t>(v.degree() * h.degree() + 1));
  Polynomial power{1};
  for (long j = 0; j <= v.degree(); ++j, power *= h)
    for (long i = 0; i <= power.degree(); ++i)
      rows[static_cast<std::size_t>(i)] += power.coefficient(i) * v.coefficient(j);
  const bool is_monic = rows.back() == Polynomial{1};
  const Bivariate result(std::move(rows));
  return is_monic ? result : primitive_part(result);
}

std::optional<ComposedArgument> as_composed(const Bivariate& v) {
  if (v.degree() < 2) return std::nullopt;
  const Polynomial lead = v.coefficient(v.degree());
  std::vector<Rational> h = {0};
  for (long j = 1; j <= v.degree(); ++j) {
    const Polynomial row = v.coefficient(j);
    const Rational factor = row.coefficient(lead.degree()) / lead.leading_coefficient();
    if (!(row == factor * lead)) return std::nullopt;
    h.push_back(factor);
  }
  return ComposedArgument{Bivariate({v.coefficient(0), lead}), Polynomial(h)};
}

}  // namespace phrame
