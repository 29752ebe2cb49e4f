#pragma once
#include <optional>
#include <vector>

#include "phrame/algebra/ball.hpp"

namespace phrame::inline v0 {

/// c·N/(D√S) as a function of x ∈ [−1, 1], with D and S coprime to 0 at x = 0: D(0) ≠ 0, S(0) > 0.
struct UnitQuotient {
  IntegerPolynomial numerator;    ///< N
  IntegerPolynomial denominator;  ///< D
  IntegerPolynomial radicand;     ///< S
  Rational factor = 1;            ///< c
};
/// numerator/(denominator·√radicand) with its factors of the same signs over ℤ.
UnitQuotient unit_quotient(const Polynomial& numerator, const Polynomial& denominator,
                           const Polynomial& radicand);
/// The same function of z ∈ [−1, 1] for x = (z + side)/2: the left half, side = −1, or the right
/// one, side = 1.
UnitQuotient half_of(const UnitQuotient& f, long side);

/// f = unit_factor(f)·G with G = ν/(δ√σ): σ = S/S(0), δ = D/D(0), ν = N/2ᵉ, Σ |νⱼ| < 1.
RealBall unit_factor(const UnitQuotient& f, long bits);
/// e.
long unit_exponent(const IntegerPolynomial& numerator);
/// The coefficients of p, or of p/2ᵉ, over p(0): each is off by its 2⁻⁵⁰-th part at most, where it
/// is finite and above 1e-300.
std::vector<double> unit_ratios(const IntegerPolynomial& p);

/// What doubles prove of a UnitQuotient on [−1, 1], where its Taylor series do well.
struct UnitBounds {
  double root;           ///< 1/√σ is no greater
  double quotient;       ///< 1/|δ| is no greater
  double bits_per_term;  ///< by which the coefficients of both get smaller, about
  double mean_size;      ///< about the mean of |G|, a guess
};
/// No value where the Taylor coefficients of 1/√S and 1/D do not get smaller quickly, or too slowly
/// to prove that D and S have no zero on [−1, 1]: by polynomials u ≈ 1/√σ and q ≈ 1/δ with
///   Σ|coefficients of σu² − 1| ≤ 1/2, so that 1/√σ ≤ √2·|u|, and the same of δq − 1, 1/|δ| ≤ 2|q|.
std::optional<UnitBounds> unit_bounds(const UnitQuotient& f);

}  // namespace phrame
