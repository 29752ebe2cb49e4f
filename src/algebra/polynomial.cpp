#include "phrame/algebra/polynomial.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <ostream>

#include "phrame/algebra/error.hpp"
#include "phrame/algebra/modular.hpp"
#include "phrame/algebra/result_of.hpp"

namespace phrame::inline v0 {
namespace {

/// From so many words on an integer is long.
constexpr slong long_limbs = 16;

/// From so many words on a gcd with a denominator takes longer than a product modulo it.
constexpr slong long_gcd_limbs = 4;

/// Are the coefficients of a long beside those of b? Then the schoolbook algorithms are faster than
/// FLINT's choice, which pads all coefficients to one length.
bool is_long_beside(const fmpz* a, slong length_a, const fmpz* b, slong length_b) {
  constexpr slong most_terms = 1024;
  constexpr slong short_limbs = 2;
  return std::min(length_a, length_b) <= most_terms &&
         std::abs(_fmpz_vec_max_bits(b, length_b)) <= short_limbs * FLINT_BITS &&
         std::abs(_fmpz_vec_max_bits(a, length_a)) >= long_limbs * FLINT_BITS;
}

}  // namespace

Polynomial::Polynomial(const std::vector<Rational>& ascending) {
  fmpq_poly_fit_length(raw(), static_cast<slong>(ascending.size()));
  // From the top down: FLINT then brings the whole to a common denominator in place.
  for (std::size_t k = ascending.size(); k-- > 0;)
    fmpq_poly_set_coeff_fmpq(raw(), static_cast<slong>(k), ascending[k].raw());
}

Polynomial Polynomial::monomial(const Rational& c, long k) {
  return result_of<Polynomial>(fmpq_poly_set_coeff_fmpq, k, c.raw());
}

Rational Polynomial::coefficient(long k) const {
  return result_of<Rational>(fmpq_poly_get_coeff_fmpq, raw(), k);
}

// Of the coefficients n_k/d the gcd of n_k and d divides g = gcd(∏ n_k, d), so that it is that of
// n_k and g, which is nearly always short: one long gcd instead of one for each coefficient.
std::vector<Rational> Polynomial::coefficients() const {
  const auto size = static_cast<std::size_t>(degree() + 1);
  std::vector<Rational> ascending(size);
  const fmpz* d = fmpq_poly_denref(raw());
  if (fmpz_size(d) < long_gcd_limbs || size <= 2) {
    for (std::size_t k = 0; k < size; ++k) ascending[k] = coefficient(static_cast<long>(k));
    return ascending;
  }
  flint::Fmpz g;
  fmpz_one(g.get());
  for (const fmpz* n = raw()->coeffs; n != raw()->coeffs + size; ++n) {
    if (fmpz_is_zero(n) != 0) continue;
    fmpz_mul(g.get(), g.get(), n);
    fmpz_mod(g.get(), g.get(), d);
  }
  fmpz_gcd(g.get(), g.get(), d);
  flint::Fmpz common;
  for (std::size_t k = 0; k < size; ++k) {
    const fmpz* n = raw()->coeffs + k;
    if (fmpz_is_zero(n) != 0) continue;
    fmpz_gcd(common.get(), n, g.get());
    fmpz_divexact(fmpq_numref(ascending[k].raw()), n, common.get());
    fmpz_divexact(fmpq_denref(ascending[k].raw()), d, common.get());
  }
  return ascending;
}

Rational Polynomial::operator()(const Rational& t) const {
  if (t == 0 || is_constant()) return coefficient(0);
  if (t == 1) {
    Rational value;
    fmpz* sum = fmpq_numref(value.raw());
    _fmpz_vec_sum(sum, raw()->coeffs, raw()->length);
    fmpz_set(fmpq_denref(value.raw()), raw()->den);
    fmpq_canonicalise(value.raw());
    return value;
  }
  return result_of<Rational>(fmpq_poly_evaluate_fmpq, raw(), t.raw());
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
  const auto [x, y] = std::pair(raw(), b.raw());
  if (!is_long_beside(x->coeffs, x->length, y->coeffs, y->length) &&
      !is_long_beside(y->coeffs, y->length, x->coeffs, x->length)) {
    fmpq_poly_mul(x, x, y);
    return *this;
  }
  flint::FmpzPoly product;
  flint::FmpzPoly other;
  flint::Fmpz denominator;
  fmpz_mul(denominator.get(), fmpq_poly_denref(x), fmpq_poly_denref(y));
  fmpq_poly_get_numerator(product.get(), x);
  fmpq_poly_get_numerator(other.get(), y);
  fmpz_poly_mul_classical(product.get(), product.get(), other.get());
  fmpq_poly_set_fmpz_poly(x, product.get());
  fmpq_poly_scalar_div_fmpz(x, x, denominator.get());
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
  return result_of<Polynomial>(fmpq_poly_rem, a.raw(), b.raw());
}

namespace {

/// Quotient and remainder over ℚ of the numerator of a and the primitive part of b, where the
/// quotient is integral, as it is where b divides a (Gauss's lemma); else the remainder has at
/// least the degree of b.
struct IntegerDivision {
  flint::FmpzPoly quotient;
  flint::FmpzPoly remainder;

  IntegerDivision(const Polynomial& a, const Polynomial& b) {
    flint::FmpzPoly numerator;
    fmpq_poly_get_numerator(numerator.get(), a.raw());
    const flint::FmpzPoly divisor = integer_primitive_part(b);
    const bool is_long = is_long_beside(numerator.get()->coeffs, numerator.get()->length,
                                        divisor.get()->coeffs, divisor.get()->length);
    (is_long ? fmpz_poly_divrem_basecase : fmpz_poly_divrem)(quotient.get(), remainder.get(),
                                                             numerator.get(), divisor.get());
  }
};

}  // namespace

Polynomial short_remainder(const Polynomial& a, const Polynomial& b) {
  if (b.is_zero()) throw DomainError("remainder: the divisor is the zero polynomial");
  const IntegerDivision division(a, b);
  if (fmpz_poly_degree(division.remainder.get()) >= b.degree()) return a % b;
  Polynomial r = to_polynomial(division.remainder.get());
  fmpq_poly_scalar_div_fmpz(r.raw(), r.raw(), fmpq_poly_denref(a.raw()));
  return r;
}

Polynomial exact_quotient(const Polynomial& a, const Polynomial& b) {
  if (b.is_zero()) throw DomainError("exact_quotient: the divisor is the zero polynomial");
  if (b.is_constant()) return (1 / b.coefficient(0)) * a;
  const IntegerDivision division(a, b);
  if (fmpz_poly_is_zero(division.remainder.get()) == 0)
    throw DomainError(
        fmt::format("exact_quotient: a divisor of degree {} leaves a remainder of degree {}",
                    b.degree(), (a % b).degree()));
  Polynomial quotient = to_polynomial(division.quotient.get());
  fmpq_poly_scalar_div_fmpz(quotient.raw(), quotient.raw(), fmpq_poly_denref(a.raw()));
  return (1 / content(b)) * std::move(quotient);
}

Integer denominator(const Polynomial& p) { return Integer(fmpq_poly_denref(p.raw())); }

Polynomial lcm(const Polynomial& a, const Polynomial& b) {
  return a * exact_quotient(b, gcd(a, b));
}

Polynomial gcd(const Polynomial& a, const Polynomial& b) {
  if (a.degree() == 0 || b.degree() == 0) return {1};
  flint::FmpzPoly p = integer_numerator(a);
  flint::FmpzPoly q = integer_numerator(b);
  if (!a.is_zero() && are_seen_coprime(p, q)) return {1};
  fmpz_poly_primitive_part(p.get(), p.get());
  fmpz_poly_primitive_part(q.get(), q.get());
  flint::FmpzPoly g;
  fmpz_poly_gcd(g.get(), p.get(), q.get());
  return to_polynomial(g.get());
}

ExtendedGcd extended_gcd(const Polynomial& a, const Polynomial& b) {
  ExtendedGcd result;
  fmpq_poly_xgcd(result.g.raw(), result.s.raw(), result.t.raw(), a.raw(), b.raw());
  return result;
}

Rational content(const Polynomial& p) {
  Rational c;
  fmpq_poly_content(c.raw(), p.raw());
  return p.leading_coefficient() < 0 ? -c : c;
}

Rational common_content(const std::vector<Polynomial>& polynomials) {
  Rational common = 0;
  for (const Polynomial& p : polynomials) {
    if (p.is_zero()) continue;
    const Rational c = abs(content(p));
    common = common == 0 ? c
                         : Rational(gcd(numerator(common), numerator(c)),
                                    lcm(denominator(common), denominator(c)));
  }
  return common;
}

Polynomial primitive_part(const Polynomial& p) {
  return to_polynomial(integer_primitive_part(p).get());
}

IntegerPolynomial integer_numerator(const Polynomial& p) {
  IntegerPolynomial result;
  fmpq_poly_get_numerator(result.get(), p.raw());
  return result;
}

long primitive_bits(const Polynomial& p) {
  return std::abs(fmpz_poly_max_bits(integer_primitive_part(p).get()));
}

IntegerPolynomial integer_primitive_part(const Polynomial& p) {
  IntegerPolynomial result = integer_numerator(p);
  fmpz_poly_primitive_part(result.get(), result.get());  // its leading coefficient is positive
  return result;
}

Polynomial to_polynomial(const fmpz_poly_t p) {
  return result_of<Polynomial>(fmpq_poly_set_fmpz_poly, p);
}

Polynomial differentiate(const Polynomial& p) {
  return result_of<Polynomial>(fmpq_poly_derivative, p.raw());
}

Polynomial antiderivative(const Polynomial& p) {
  return result_of<Polynomial>(fmpq_poly_integral, p.raw());
}

Polynomial compose(const Polynomial& p, const Polynomial& q) {
  return result_of<Polynomial>(fmpq_poly_compose, p.raw(), q.raw());
}

Polynomial pow(const Polynomial& p, long k) {
  if (k < 0) throw DomainError(fmt::format("pow: the exponent {} of a polynomial is negative", k));
  return result_of<Polynomial>(fmpq_poly_pow, p.raw(), static_cast<ulong>(k));
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
  if (is_seen_squarefree(integer_numerator(p))) return primitive_part(p);
  const Polynomial repeated = gcd(p, differentiate(p));
  return repeated.is_constant() ? primitive_part(p) : exact_quotient(primitive_part(p), repeated);
}

bool is_squarefree(const Polynomial& p) {
  if (is_seen_squarefree(integer_numerator(p))) return true;
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

int sign_before_one(const Polynomial& p) {
  return sign_after_zero(p.is_constant() ? p : compose(p, Polynomial{1, -1}));
}

std::ostream& operator<<(std::ostream& out, const Polynomial& p) { return out << to_string(p); }

}  // namespace phrame
