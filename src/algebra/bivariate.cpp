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

Polynomial evaluate_at(const Bivariate& v, const Rational& t) {
  Polynomial value;
  for (long k = v.degree(); k >= 0; --k) value = t * std::move(value) + v.coefficient(k);
  return value;
}

QuotientRing::QuotientRing(Polynomial q) : modulus_(std::move(q)) {
  if (modulus_.is_constant())
    throw DomainError("QuotientRing: the modulus must have degree ≥ 1");
  const long n = modulus_.degree();
  const Rational lead = modulus_.leading_coefficient();
  std::vector<Rational> c;
  for (long k = n - 1; k >= 0; --k) c.push_back(modulus_.coefficient(k) / lead);
  power_sums_ = power_sums(c, n - 1, std::multiplies<Rational>());
  power_sums_.insert(power_sums_.begin(), Rational(n));
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
    throw DomainError(fmt::format("inverse in ℚ[x]/(q): the element has a factor of degree {} in "
                                  "common with q",
                                  g.degree()));
  return s;
}

Rational QuotientRing::trace(const Polynomial& a) const {
  const Polynomial reduced = reduce(a);
  Rational sum = 0;
  for (long k = 0; k <= reduced.degree(); ++k)
    sum += reduced.coefficient(k) * power_sums_[static_cast<std::size_t>(k)];
  return sum;
}

}  // namespace phrame
