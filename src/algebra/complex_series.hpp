#pragma once
#include <vector>

#include "phrame/algebra/ball_polynomial.hpp"

namespace phrame::inline v0 {

/// A power series in one variable with complex balls for coefficients, of which the first ones are
/// there: the Taylor series of an analytic function around every point of a disc, where the first
/// coefficient is a ball around that disc. A function that is not analytic on the whole of it, as
/// where it meets the branch cut of the principal logarithm, has coefficients that are not finite.
class ComplexSeries {
 public:
  ComplexSeries() = default;  ///< exactly 0
  /// The coefficients of t⁰, t¹, …
  explicit ComplexSeries(const std::vector<ComplexBall>& ascending);

  ComplexBall coefficient(long k) const;  ///< 0 beyond the last one; k ≥ 0

  /// Is it exactly 0?
  bool is_zero() const { return acb_poly_length(raw()) == 0; }

  acb_poly_struct* raw() { return handle_.get(); }
  const acb_poly_struct* raw() const { return handle_.get(); }

 private:
  flint::AcbPoly handle_;
};

/// p(z + t).
ComplexSeries series_at(const BallPolynomial& p, const ComplexBall& z, long length, long bits);
/// (p − p(0))/t.
ComplexSeries without_constant(const ComplexSeries& p);
/// @{ As the functions of the same names for real series.
ComplexSeries add(const ComplexSeries& p, const ComplexSeries& q, long bits);
ComplexSeries multiply(const RealBall& c, const ComplexSeries& p, long bits);
ComplexSeries multiply_series(const ComplexSeries& p, const ComplexSeries& q, long length,
                              long bits);
ComplexSeries divide_series(const ComplexSeries& p, const ComplexSeries& q, long length, long bits);
ComplexSeries exp_series(const ComplexSeries& p, long length, long bits);
ComplexSeries log_series(const ComplexSeries& p, long length, long bits);
ComplexSeries atan_series(const ComplexSeries& p, long length, long bits);
ComplexSeries sqrt_series(const ComplexSeries& p, long length, long bits);
ComplexSeries pow_series(const ComplexSeries& p, unsigned long k, long length, long bits);
/// @}

/// The cosine and the sine of one series.
struct ComplexCosSinSeries {
  ComplexSeries cos;  ///< cos p
  ComplexSeries sin;  ///< sin p
};
/// Both of p.
ComplexCosSinSeries cos_sin_series(const ComplexSeries& p, long length, long bits);

}  // namespace phrame
