#pragma once
#include <optional>

#include "phrame/algebra/grid_polynomial.hpp"
#include "phrame/algebra/polynomial.hpp"

namespace phrame::inline v0 {

/// Polynomials that are about 1/√S and about N/(D√S) on |z| ≤ 1.
struct GridQuotient {
  GridPolynomial root;  ///< 1/√S
  GridPolynomial rate;  ///< N/(D√S)
};

/// From the power series of both, whose rate is off by about 2^−bits if their coefficients get
/// smaller by 3/2 bits a term; if not, it is off by more, or there is no value. N = 0 has the rate
/// 0 and a root of some bits. Integer arithmetic alone: the same on every machine. Precondition:
/// D(0) ≠ 0, S(0) > 0.
std::optional<GridQuotient> grid_quotient(const Polynomial& numerator,
                                          const Polynomial& denominator, const Polynomial& radicand,
                                          long bits);

}  // namespace phrame
