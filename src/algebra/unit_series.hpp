#pragma once
#include <variant>

#include "phrame/algebra/ball_polynomial.hpp"
#include "phrame/algebra/shared.hpp"
#include "phrame/algebra/unit_number.hpp"
#include "phrame/algebra/unit_quotient.hpp"

namespace phrame::inline v0 {

/// An antiderivative of G = ν/(δ√σ) on [−1, 1], as in unit_factor(), nearly.
struct UnitSeries {
  /// Of x¹, x², … in Y, in units of 2^−Q.
  std::variant<std::vector<TwoWords>, std::vector<Integer>> coefficients;
  long Q = 0;      ///< so many bits are behind the point
  RealBall start;  ///< Y(−1)
  RealBall whole;  ///< Y(1) − Y(−1)
  RealBall error;  ///< Y(b) − Y(a) is off by no more, −1 ≤ a < b ≤ 1
  RealBall size;   ///< |G| is no greater

  /// Y, whose coefficients are numbers without a radius; made in the first call, as the whole
  /// integral does without.
  const BallPolynomial& integral() const;

 private:
  Lazy<BallPolynomial> integral_;
};

/// With an error of about 2^−bits. `bounds` are those of f. No value where the coefficients get
/// smaller far more slowly than these let expect.
///
/// In fixed point: w ≈ 1/√σ, y ≈ ν·w/δ by the recurrences that σ and δ give, where each step rounds
/// down to a multiple of 2^−Q. The factors from σ, δ and ν have as many bits as the coefficients
/// that they are multiplied by still have, which get fewer: half of the work, or less. What a step
/// leaves over is known without computing it: its rounding, and that of its factors.
std::optional<UnitSeries> unit_series(const UnitQuotient& f, const UnitBounds& bounds, long bits);

}  // namespace phrame
