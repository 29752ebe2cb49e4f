#pragma once
#include "phrame/algebra/polynomial.hpp"

namespace phrame {

/// A polynomial over ℚ(i): re + i·im.
struct GaussianPolynomial {
  Polynomial re;
  Polynomial im;

  friend bool operator==(const GaussianPolynomial&, const GaussianPolynomial&) = default;
};

GaussianPolynomial operator+(const GaussianPolynomial& a, const GaussianPolynomial& b);
GaussianPolynomial operator-(const GaussianPolynomial& a, const GaussianPolynomial& b);
GaussianPolynomial operator*(const GaussianPolynomial& a, const GaussianPolynomial& b);
GaussianPolynomial operator*(const Polynomial& a, const GaussianPolynomial& b);

bool is_zero(const GaussianPolynomial& a);
long degree(const GaussianPolynomial& a);
/// The coefficients conjugated; the variable is real.
GaussianPolynomial conjugate(const GaussianPolynomial& a);
GaussianPolynomial differentiate(const GaussianPolynomial& a);
/// |a|² = a·ā ∈ ℚ[t].
Polynomial norm(const GaussianPolynomial& a);
/// a over its leading coefficient. Throws DomainError for 0.
GaussianPolynomial monic(const GaussianPolynomial& a);

}  // namespace phrame
