#include "phrame/algebra/bivariate.hpp"

#include <fmt/format.h>

#include "phrame/algebra/error.hpp"
#include "phrame/algebra/hadamard.hpp"
#include "phrame/algebra/modular_lift.hpp"

namespace phrame::inline v0 {

Bivariate::Bivariate(std::vector<Polynomial> ascending) : coefficients_(std::move(ascending)) {
  while (!coefficients_.empty() && coefficients_.back().is_zero()) coefficients_.pop_back();
}

Polynomial Bivariate::coefficient(long k) const {
  return k <= degree() ? coefficients_[static_cast<std::size_t>(k)] : Polynomial();
}

Bivariate operator+(const Bivariate& a, const Bivariate& b) {
  std::vector<Polynomial> rows;
  for (long k = 0; k <= std::max(a.degree(), b.degree()); ++k)
    rows.push_back(a.coefficient(k) + b.coefficient(k));
  return Bivariate(std::move(rows));
}

Bivariate operator*(const Bivariate& a, const Bivariate& b) {
  if (a.is_zero() || b.is_zero()) return {};
  std::vector<Polynomial> rows(a.coefficients().size() + b.coefficients().size() - 1);
  for (std::size_t j = 0; j < a.coefficients().size(); ++j)
    for (std::size_t k = 0; k < b.coefficients().size(); ++k)
      rows[j + k] += a.coefficients()[j] * b.coefficients()[k];
  return Bivariate(std::move(rows));
}

Bivariate operator*(const Rational& c, const Bivariate& v) {
  return Bivariate({Polynomial{c}}) * v;
}

std::vector<Polynomial> from_rows(const std::vector<Rational>& list, long size) {
  std::vector<Polynomial> rows;
  for (auto at = list.begin(); at != list.end(); at += size)
    rows.emplace_back(std::vector(at, at + size));
  return rows;
}

Bivariate primitive_part(const Bivariate& v) {
  const bool is_positive = v.coefficient(v.degree()).leading_coefficient() > 0;
  const Rational content = (is_positive ? 1 : -1) * common_content(v.coefficients());
  std::vector<Polynomial> rows;
  for (const Polynomial& row : v.coefficients()) rows.push_back((1 / content) * row);
  return Bivariate(std::move(rows));
}

std::vector<IntegerPolynomial> integer_rows(const Bivariate& v) {
  const Bivariate primitive = primitive_part(v);
  std::vector<IntegerPolynomial> rows;
  for (const Polynomial& row : primitive.coefficients()) rows.push_back(integer_numerator(row));
  return rows;
}

Polynomial evaluate_at(const Bivariate& v, const Rational& t) {
  Polynomial value;
  for (long k = v.degree(); k >= 0; --k) value = t * std::move(value) + v.coefficient(k);
  return value;
}

QuotientRing::QuotientRing(Polynomial q) : modulus_(std::move(q)) {
  if (modulus_.is_constant()) throw DomainError("QuotientRing: the modulus must have degree ≥ 1");
}

Bivariate QuotientRing::reduce(const Bivariate& v) const {
  std::vector<Polynomial> reduced;
  for (const Polynomial& c : v.coefficients()) reduced.push_back(reduce(c));
  return Bivariate(std::move(reduced));
}

namespace {

[[noreturn]] void refuse(const Polynomial& common) {
  throw DomainError(
      fmt::format("inverse in ℚ[x]/(q): the element has a factor of degree {} in "
                  "common with q",
                  common.degree()));
}

void require_coprime(const Polynomial& a, const Polynomial& q) {
  if (const Polynomial common = gcd(a, q); !common.is_constant()) refuse(common);
}

/// By Euclid's algorithm over ℚ.
Polynomial euclidean_inverse(const Polynomial& a, const Polynomial& q) {
  Polynomial g;
  Polynomial s;
  Polynomial t;
  fmpq_poly_xgcd(g.raw(), s.raw(), t.raw(), a.raw(), q.raw());  // g = s·a + t·q, monic
  if (!(g == Polynomial{1})) refuse(g);
  return s;
}

}  // namespace

// Of degree ≤ 3 Euclid's algorithm over ℚ is the faster one. Otherwise, with n, a and q in ℤ[x],
// R·(n·a⁻¹ mod q) has integer coefficients for the resultant R of q and a (Cramer), and Hadamard's
// inequality bounds them: they are lifted from their residues modulo primes, and R with them, as
// one more coefficient. n and a are not reduced before, but modulo the primes: their remainders
// modulo q have coefficients that are much longer, for which the bound would be far too large.
Polynomial QuotientRing::divide(const Polynomial& n, const Polynomial& a) const {
  const slong size = modulus_.degree();
  if (n.is_zero() || a.is_zero()) require_coprime(a, modulus_);
  if (n.is_zero()) return {};
  if (a.is_constant()) return (1 / a.coefficient(0)) * reduce(n);
  if (size <= 3) return multiply(reduce(n), euclidean_inverse(reduce(a), modulus_));
  const std::vector<flint::FmpzPoly> inputs{integer_primitive_part(n), integer_primitive_part(a),
                                            integer_primitive_part(modulus_)};
  const long formal = formal_degree(inputs[0], inputs[1], inputs[2]);
  bool coprime = false;
  const auto image = [&](std::vector<ModularPolynomial> f) -> std::optional<ModularPolynomial> {
    if (f[2].degree() != size) return std::nullopt;
    phrame::reduce(f[0], f[2]);
    phrame::reduce(f[1], f[2]);
    auto inverse = f[1].is_zero() ? std::nullopt : modular_inverse(f[1], f[2]);
    if (!inverse) {
      if (!coprime) require_coprime(a, modulus_);
      coprime = true;
      return std::nullopt;
    }
    const nmod_t mod = f[2].raw()->mod;
    const ulong lead =
        nmod_pow_ui(f[2].coefficient(size), static_cast<ulong>(formal - f[1].degree()), mod);
    const ulong resultant = nmod_mul(inverse->resultant, lead, mod);
    ModularPolynomial c = multiply_modulo(inverse->inverse, f[0], f[2]);
    nmod_poly_scalar_mul_nmod(c.raw(), c.raw(), resultant);
    nmod_poly_set_coeff_ui(c.raw(), size, resultant);
    return c;
  };
  flint::FmpzPoly lifted =
      modular_lift(inputs, size + 1, cofactor_bits(inputs[0], inputs[1], inputs[2]), image);
  flint::Fmpz resultant;
  fmpz_poly_get_coeff_fmpz(resultant.get(), lifted.get(), size);
  fmpz_poly_truncate(lifted.get(), size);
  Polynomial result = to_polynomial(lifted.get());
  fmpq_poly_scalar_div_fmpz(result.raw(), result.raw(), resultant.get());
  return Rational(content(n) / content(a)) * std::move(result);
}

// Σ a(α) is the sum of the residues of a·q′/q, which is the coefficient of 1/x in its expansion at
// ∞: that of xⁿ⁻¹ in a·q′ mod q, over lead(q).
Rational QuotientRing::trace(const Polynomial& a) const {
  const Polynomial weighted = multiply(a, differentiate(modulus_));
  return weighted.coefficient(modulus_.degree() - 1) / modulus_.leading_coefficient();
}

}  // namespace phrame
