#include "phrame/algebra/gaussian_polynomial.hpp"

#include <algorithm>

#include "phrame/algebra/error.hpp"

namespace phrame {

GaussianPolynomial operator+(const GaussianPolynomial& a, const GaussianPolynomial& b) {
  return {a.re + b.re, a.im + b.im};
}

GaussianPolynomial operator-(const GaussianPolynomial& a, const GaussianPolynomial& b) {
  return {a.re - b.re, a.im - b.im};
}

GaussianPolynomial operator*(const GaussianPolynomial& a, const GaussianPolynomial& b) {
  return {a.re * b.re - a.im * b.im, a.re * b.im + a.im * b.re};
}

GaussianPolynomial operator*(const Polynomial& a, const GaussianPolynomial& b) {
  return {a * b.re, a * b.im};
}

bool is_zero(const GaussianPolynomial& a) { return a.re.is_zero() && a.im.is_zero(); }

long degree(const GaussianPolynomial& a) { return std::max(a.re.degree(), a.im.degree()); }

GaussianPolynomial conjugate(const GaussianPolynomial& a) { return {a.re, -a.im}; }

GaussianPolynomial differentiate(const GaussianPolynomial& a) {
  return {differentiate(a.re), differentiate(a.im)};
}

Polynomial norm(const GaussianPolynomial& a) { return a.re * a.re + a.im * a.im; }

GaussianPolynomial monic(const GaussianPolynomial& a) {
  if (is_zero(a)) throw DomainError("monic: the zero polynomial has no leading coefficient");
  const long n = degree(a);
  const Rational re = a.re.coefficient(n);
  const Rational im = a.im.coefficient(n);
  const Rational scale = 1 / Rational(re * re + im * im);
  return GaussianPolynomial{{re * scale}, {-im * scale}} * a;
}

}  // namespace phrame
