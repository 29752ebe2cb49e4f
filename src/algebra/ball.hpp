#pragma once
#include "phrame/algebra/gaussian_polynomial.hpp"
#include "phrame/algebra/rational_function.hpp"
#include "phrame/export.hpp"

namespace phrame::inline v0 {

/// A set [midpoint − radius, midpoint + radius] that contains a real number. Functions of balls
/// return a ball that contains every value on their arguments, computed with `bits` bits of
/// working precision (Johansson, Arb: efficient arbitrary-precision midpoint-radius interval
/// arithmetic).
class PHRAME_API RealBall {
 public:
  RealBall() = default;  ///< exactly 0
  /// A ball around x; its radius is 0 where x is dyadic and has at most that many bits.
  RealBall(const Rational& x, long bits);
  /// All real numbers: the enclosure of a value that could not be computed.
  static RealBall unknown();

  /// @{ The ends, the radius and the midpoint, exactly. Precondition: is_finite().
  Rational lower() const;
  Rational upper() const;
  Rational radius() const;
  Rational midpoint() const;
  /// @}
  /// Are both ends finite?
  bool is_finite() const { return arb_is_finite(raw()) != 0; }
  /// Is the number known to be 0?
  bool is_zero() const { return arb_is_zero(raw()) != 0; }
  /// May the number be x?
  bool contains(const Rational& x) const;
  /// May the number be 0?
  bool contains_zero() const { return arb_contains_zero(raw()) != 0; }
  /// May the two numbers be equal?
  bool overlaps(const RealBall& other) const { return arb_overlaps(raw(), other.raw()) != 0; }
  /// Is the radius ≤ 2^−bits · max(1, |x|) for every x in the ball?
  bool is_accurate(long bits) const;
  /// The relative accuracy in bits; a large negative number for a ball that contains 0.
  long accuracy_bits() const { return arb_rel_accuracy_bits(raw()); }

  arb_struct* raw() { return handle_.get(); }
  const arb_struct* raw() const { return handle_.get(); }

 private:
  flint::Arb handle_;
};

/// −1 or 1 where all numbers in the ball have that sign; otherwise 0.
PHRAME_API int sign(const RealBall& a);
PHRAME_API RealBall absolute(const RealBall& a);  ///< |a|
/// A double near the midpoint, for estimates that need no proof.
PHRAME_API double approximate(const RealBall& a);
/// A double that no number of the ball exceeds: the least such double or the next one; +∞ where
/// there is none.
PHRAME_API double upper_double(const RealBall& a);
/// A ball that contains [a, b].
PHRAME_API RealBall hull(const Rational& a, const Rational& b, long bits);
/// A ball that contains both.
PHRAME_API RealBall hull(const RealBall& a, const RealBall& b, long bits);

/// @{ The sum, difference, product and quotient; a quotient is not finite where b contains 0.
PHRAME_API RealBall add(const RealBall& a, const RealBall& b, long bits);
PHRAME_API RealBall subtract(const RealBall& a, const RealBall& b, long bits);
PHRAME_API RealBall multiply(const RealBall& a, const RealBall& b, long bits);
PHRAME_API RealBall divide(const RealBall& a, const RealBall& b, long bits);
/// @}
/// sum + a·b, rounded once.
PHRAME_API RealBall add_product(RealBall sum, const RealBall& a, const RealBall& b, long bits);
/// √a; not finite where the ball has negative numbers.
PHRAME_API RealBall sqrt(const RealBall& a, long bits);
/// aᵏ, k ≥ 0.
PHRAME_API RealBall pow(const RealBall& a, long k, long bits);
/// √a for a number that is known to be ≥ 0, although its ball may contain negative ones.
PHRAME_API RealBall sqrt_of_nonnegative(const RealBall& a, long bits);
/// 2ᵏ·a, exactly.
PHRAME_API RealBall times_power_of_two(RealBall a, long k);
/// a + b, exactly.
PHRAME_API RealBall exact_sum(double a, double b);
/// @{ x + y for all x of the ball and |y| ≤ |by|.
PHRAME_API RealBall widened(RealBall a, const RealBall& by);
PHRAME_API RealBall widened(RealBall a, double by);
/// @}
PHRAME_API RealBall pi(long bits);  ///< π
/// The principal argument of x + iy ≠ 0, in (−π, π].
PHRAME_API RealBall argument(const Rational& x, const Rational& y, long bits);

/// The cosine and the sine of one angle.
struct CosSin {
  RealBall cos;  ///< cos φ
  RealBall sin;  ///< sin φ
};
/// Both for an angle in radians.
PHRAME_API CosSin cos_sin(const RealBall& angle, long bits);

/// A rectangle of two real balls that contains a complex number.
class PHRAME_API ComplexBall {
 public:
  ComplexBall() = default;                              ///< exactly 0
  ComplexBall(const RealBall& re, const RealBall& im);  ///< re + i·im
  /// All complex numbers.
  static ComplexBall unknown();

  RealBall re() const;  ///< the real part
  RealBall im() const;  ///< the imaginary part
  /// The midpoint, exactly.
  ComplexBall midpoint() const;
  /// May the two numbers be equal?
  bool overlaps(const ComplexBall& other) const { return acb_overlaps(raw(), other.raw()) != 0; }
  /// Are all numbers of the other in this one?
  bool contains(const ComplexBall& other) const { return acb_contains(raw(), other.raw()) != 0; }
  /// Are both the same rectangle? The two numbers need not be equal then.
  bool is_same_ball(const ComplexBall& other) const { return acb_equal(raw(), other.raw()) != 0; }
  /// The relative accuracy in bits; a large negative number for a ball that contains 0.
  long accuracy_bits() const { return acb_rel_accuracy_bits(raw()); }

  acb_struct* raw() { return handle_.get(); }
  const acb_struct* raw() const { return handle_.get(); }

 private:
  flint::Acb handle_;
};

PHRAME_API ComplexBall conjugate(const ComplexBall& z);         ///< the complex conjugate
PHRAME_API RealBall absolute(const ComplexBall& z, long bits);  ///< |z|
/// @{ The sum, difference and product.
PHRAME_API ComplexBall add(const ComplexBall& a, const ComplexBall& b, long bits);
PHRAME_API ComplexBall subtract(const ComplexBall& a, const ComplexBall& b, long bits);
PHRAME_API ComplexBall multiply(const ComplexBall& a, const ComplexBall& b, long bits);
PHRAME_API ComplexBall multiply(const RealBall& a, const ComplexBall& b, long bits);
/// @}
/// The principal argument, in (−π, π]; all of [−π, π] where the ball meets the negative real axis.
PHRAME_API RealBall argument(const ComplexBall& z, long bits);
/// The argument in (0, 2π], π + arg(−z): for a z near the negative real axis, where the principal
/// one jumps.
PHRAME_API RealBall argument_about_pi(const ComplexBall& z, long bits);
/// @{ p(z).
PHRAME_API ComplexBall evaluate(const Polynomial& p, const ComplexBall& z, long bits);
PHRAME_API RealBall evaluate(const Polynomial& p, const RealBall& x, long bits);
/// @}
/// f(x); not finite where the ball of the denominator contains 0.
PHRAME_API RealBall evaluate(const RationalFunction& f, const RealBall& x, long bits);
/// @{ a/b and 1/b; not finite where b contains 0.
PHRAME_API ComplexBall divide(const ComplexBall& a, const ComplexBall& b, long bits);
PHRAME_API ComplexBall inverse(const ComplexBall& b, long bits);
/// @}

/// "-0.343344423853", for messages and tables: `digits` significant digits, fewer where the ball is
/// wide; "0" for a ball that contains 0.
PHRAME_API std::string to_string(const RealBall& a, long digits);

/// @{ Writes "[0.333333333333333 +/- 3.34e-16]": up to 15 digits and a bound of the distance
/// between them and any number of the ball; "[…] + […]*i" for a complex one.
PHRAME_API std::ostream& operator<<(std::ostream& out, const RealBall& a);
PHRAME_API std::ostream& operator<<(std::ostream& out, const ComplexBall& z);
/// @}

}  // namespace phrame
