#pragma once
#include <optional>
#include <vector>

#include "phrame/algebra/polynomial.hpp"

namespace phrame::inline v0 {

/// Σ terms[k]·zᵏ/2^bits.
struct GridPolynomial {
  std::vector<Integer> terms;  ///< maybe with zeros at the end
  long bits = 0;               ///< ≥ 0
  friend bool operator==(const GridPolynomial&, const GridPolynomial&) = default;
};

/// What is on the grid.
Polynomial to_polynomial(const GridPolynomial& p);
/// Σ |coefficients|, so that |p(z)| is no greater for |z| ≤ 1.
Rational sum_of_sizes(const Polynomial& p);

/// Polynomials that are about 1/√S and about N/(D√S) on |z| ≤ 1.
struct GridQuotient {
  GridPolynomial root;  ///< 1/√S
  GridPolynomial rate;  ///< N/(D√S)
};
/// From the power series of both, which are off by about 2^−bits in the rate, if they get smaller
/// by 3/2 bits a term; if not, by more, or there is no value. N = 0 has the rate 0, and a root of
/// some bits. Integer arithmetic alone: the same on every machine. Precondition: D(0) ≠ 0, S(0) >
/// 0.
std::optional<GridQuotient> grid_quotient(const Polynomial& numerator,
                                          const Polynomial& denominator, const Polynomial& radicand,
                                          long bits);

}  // namespace phrame
