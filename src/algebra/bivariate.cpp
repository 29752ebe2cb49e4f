#include "phrame/algebra/bivariate.hpp"

#include <fmt/format.h>

#include "phrame/algebra/error.hpp"

namespace phrame {

Bivariate::Bivariate(std::vector<Polynomial> ascending) : coefficients_(std::move(ascending)) {
  while (!coefficients_.empty() && coefficients_.back().is_zero()) coefficients_.pop_back();
}

Polynomial Bivariate::coefficient(long k) const {
  return k <= degree() ? coefficients_[static_cast<std::size_t>(k)] : Polynomial();
}

Bivariate monic_from_rows(const std::vector<Rational>& list, long size) {
  std::vector<Polynomial> rows;
  for (auto at = list.begin(); at != list.end(); at += size)
    rows.emplace_back(std::vector(at, at + size));
  rows.push_back(Polynomial{1});
  return Bivariate(std::move(rows));
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

Polynomial QuotientRing::inverse(const Polynomial& a) const {
  Polynomial g;
  Polynomial s;
  Polynomial t;
  fmpq_poly_xgcd(g.raw(), s.raw(), t.raw(), a.raw(), modulus_.raw());  // g = s·a + t·q, monic
  if (!(g == Polynomial{1}))
    throw DomainError(
        fmt::format("inverse in ℚ[x]/(q): the element has a factor of degree {} in "
                    "common with q",
                    g.degree()));
  return s;
}

// Σ a(α) is the sum of the residues of a·q′/q, which is the coefficient of 1/x in its expansion at
// ∞: that of xⁿ⁻¹ in a·q′ mod q, over lead(q).
Rational QuotientRing::trace(const Polynomial& a) const {
  const Polynomial weighted = multiply(a, differentiate(modulus_));
  return weighted.coefficient(modulus_.degree() - 1) / modulus_.leading_coefficient();
}

}  // namespace phrame
