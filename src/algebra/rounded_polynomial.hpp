#pragma once
#include <vector>

#include "phrame/algebra/error_free.hpp"
#include "phrame/algebra/polynomial.hpp"

namespace phrame::inline v0 {

/// The values of a polynomial over ℚ at doubles, correctly rounded, to nearest with ties to even:
/// by Horner's rule with sums of two doubles and a bound of the error, some tens of nanoseconds for
/// each; exactly, some microseconds, where that does not tell how to round. In any rounding mode.
class RoundedPolynomial {
 public:
  explicit RoundedPolynomial(Polynomial p);  ///< of p

  /// p(t). Infinite where p(t) is beyond the range of doubles. Precondition: t is finite.
  double operator()(double t) const;

 private:
  /// No value where it does not tell.
  std::optional<double> near_value(double t) const;

  Polynomial exact_;
  std::vector<DoubleDouble> coefficients_;  ///< from the highest; none where there is no such bound
};

}  // namespace phrame
