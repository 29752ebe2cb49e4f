#pragma once
#include <optional>
#include <vector>

#include "phrame/algebra/rational.hpp"

namespace phrame {

/// re + i·im.
struct GaussianRational {
  Rational re;
  Rational im;
  friend bool operator==(const GaussianRational&, const GaussianRational&) = default;
};

inline GaussianRational operator*(const GaussianRational& a, const GaussianRational& b) {
  return {a.re * b.re - a.im * b.im, a.re * b.im + a.im * b.re};
}

struct Power {
  GaussianRational base;  ///< not 0
  Rational exponent;
};

/// A number N > 0 such that N·exponent is whole for all of them.
Integer common_denominator(const std::vector<Power>& powers);

/// ∏ base^{n·exponent}, for an n that makes the exponents whole. No value where the result would
/// have more than about 2²⁴ bits. Throws DomainError for a base 0.
std::optional<GaussianRational> product(const std::vector<Power>& powers, const Integer& n);

}  // namespace phrame
