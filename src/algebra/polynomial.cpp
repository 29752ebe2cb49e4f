#include "phrame/algebra/polynomial.hpp"

#include <fmt/format.h>

#include "phrame/algebra/error.hpp"

namespace phrame {

Polynomial::Polynomial(const std::vector<Rational>& ascending) {
  fmpq_poly_fit_length(raw(), static_cast<slong>(ascending.size()));
  // From the top down: FLINT then brings the whole to a common denominator in place.
  for (std::size_t k = ascending.size(); k-- > 0;)
    fmpq_poly_set_coeff_fmpq(raw(), static_cast<slong>(k), ascending[k].raw());
}

Polynomial Polynomial::monomial(const Rational& c, long k) {
  Polynomial p;
  fmpq_poly_set_coeff_fmpq(p.raw(), k, c.raw());
  return p;
}

Rational Polynomial::coefficient(long k) const {
  Rational c;
  fmpq_poly_get_coeff_fmpq(c.raw(), raw(), k);
  return c;
}

std::vector<Rational> Polynomial::coefficients() const {
  std::vector<Rational> ascending;
  for (long k = 0; k <= degree(); ++k) ascending.push_back(coefficient(k));
  return ascending;
}

Rational Polynomial::operator()(const Rational& t) const {
  Rational value;
  fmpq_poly_evaluate_fmpq(value.raw(), raw(), t.raw());
  return value;
}

Polynomial& Polynomial::operator+=(const Polynomial& b) {
  fmpq_poly_add(raw(), raw(), b.raw());
  return *this;
}

Polynomial& Polynomial::operator-=(const Polynomial& b) {
  fmpq_poly_sub(raw(), raw(), b.raw());
  return *this;
}

Polynomial& Polynomial::operator*=(const Polynomial& b) {
  fmpq_poly_mul(raw(), raw(), b.raw());
  return *this;
}

Polynomial& Polynomial::operator*=(const Rational& c) {
  fmpq_poly_scalar_mul_fmpq(raw(), raw(), c.raw());
  return *this;
}

Division divide(const Polynomial& a, const Polynomial& b) {
  if (b.is_zero()) throw DomainError("divide: the divisor is the zero polynomial");
  Division result;
  fmpq_poly_divrem(result.quotient.raw(), result.remainder.raw(), a.raw(), b.raw());
  return result;
}

Polynomial operator%(const Polynomial& a, const Polynomial& b) {
  if (b.is_zero()) throw DomainError("remainder: the divisor is the zero polynomial");
  Polynomial r;
  fmpq_poly_rem(r.raw(), a.raw(), b.raw());
  return r;
}

Polynomial short_remainder(const Polynomial& a, const Polynomial& b) {
  if (b.is_zero()) throw DomainError("remainder: the divisor is the zero polynomial");
  flint::FmpzPoly numerator;
  flint::FmpzPoly quotient;
  flint::FmpzPoly remainder;
  fmpq_poly_get_numerator(numerator.get(), a.raw());
  // Quotient and remainder over ℚ if the remainder has the degree of one.
  fmpz_poly_divrem(quotient.get(), remainder.get(), numerator.get(),
                   integer_primitive_part(b).get());
  if (fmpz_poly_degree(remainder.get()) >= b.degree()) return a % b;
  Polynomial r = to_polynomial(remainder.get());
  fmpq_poly_scalar_div_fmpz(r.raw(), r.raw(), fmpq_poly_denref(a.raw()));
  return r;
}

Polynomial exact_quotient(const Polynomial& a, const Polynomial& b) {
  auto [quotient, remainder] = divide(a, b);
  if (!remainder.is_zero())
    throw DomainError(
        fmt::format("exact_quotient: a divisor of degree {} leaves a remainder of degree {}",
                    b.degree(), remainder.degree()));
  return std::move(quotient);
}

Polynomial gcd(const Polynomial& a, const Polynomial& b) {
  const flint::FmpzPoly p = integer_primitive_part(a);
  const flint::FmpzPoly q = integer_primitive_part(b);
  flint::FmpzPoly g;
  fmpz_poly_gcd(g.get(), p.get(), q.get());
  return to_polynomial(g.get());
}

Rational content(const Polynomial& p) {
  Rational c;
  fmpq_poly_content(c.raw(), p.raw());
  return p.leading_coefficient() < 0 ? -c : c;
}

Polynomial primitive_part(const Polynomial& p) {
  return to_polynomial(integer_primitive_part(p).get());
}

flint::FmpzPoly integer_primitive_part(const Polynomial& p) {
  flint::FmpzPoly result;
  fmpq_poly_get_numerator(result.get(), p.raw());
  fmpz_poly_primitive_part(result.get(), result.get());  // its leading coefficient is positive
  return result;
}

Polynomial to_polynomial(const fmpz_poly_t p) {
  Polynomial result;
  fmpq_poly_set_fmpz_poly(result.raw(), p);
  return result;
}

Polynomial differentiate(const Polynomial& p) {
  Polynomial result;
  fmpq_poly_derivative(result.raw(), p.raw());
  return result;
}

Polynomial antiderivative(const Polynomial& p) {
  Polynomial result;
  fmpq_poly_integral(result.raw(), p.raw());
  return result;
}

Polynomial compose(const Polynomial& p, const Polynomial& q) {
  Polynomial result;
  fmpq_poly_compose(result.raw(), p.raw(), q.raw());
  return result;
}

Polynomial pow(const Polynomial& p, long k) {
  if (k < 0) throw DomainError(fmt::format("pow: the exponent {} of a polynomial is negative", k));
  Polynomial result;
  fmpq_poly_pow(result.raw(), p.raw(), static_cast<ulong>(k));
  return result;
}

// Of a square the content is one in ℚ and the primitive part one in ℤ[t] (Gauss).
std::optional<Polynomial> square_root(const Polynomial& p) {
  const auto scale = square_root(content(p));
  flint::FmpzPoly root;
  if (!scale || fmpz_poly_sqrt(root.get(), integer_primitive_part(p).get()) == 0)
    return std::nullopt;
  return *scale * to_polynomial(root.get());
}

Polynomial squarefree_part(const Polynomial& p) {
  if (p.is_zero()) throw DomainError("squarefree_part: the zero polynomial has no finite root set");
  const Polynomial repeated = gcd(p, differentiate(p));
  return repeated.is_constant() ? primitive_part(p) : exact_quotient(primitive_part(p), repeated);
}

bool is_squarefree(const Polynomial& p) {
  return fmpz_poly_is_squarefree(integer_primitive_part(p).get()) != 0;
}

std::string to_string(const Polynomial& p) {
  std::string text;
  for (long k = p.degree(); k >= 0; --k) {
    const Rational c = p.coefficient(k);
    if (c == 0) continue;
    const Rational size = abs(c);
    text += text.empty() ? (c < 0 ? "-" : "") : (c < 0 ? " - " : " + ");
    if (size != 1 || k == 0) text += to_string(size) + (k == 0 ? "" : "*");
    if (k > 0) text += k == 1 ? "t" : "t^" + std::to_string(k);
  }
  return text.empty() ? "0" : text;
}

int sign_after_zero(const Polynomial& p) {
  for (long k = 0; k <= p.degree(); ++k)
    if (const Rational c = p.coefficient(k); c != 0) return c < 0 ? -1 : 1;
  return 0;
}

}  // namespace phrame
