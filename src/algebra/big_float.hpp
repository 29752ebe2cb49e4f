#pragma once
#include "phrame/algebra/ball.hpp"

namespace phrame::inline v0 {

/// A floating-point number with the number of bits that it is computed with. Results are rounded to
/// nearest, with the bits of the operand that has more, and nothing is known of their errors: these
/// are guesses, for an exact test to judge, from formulas that are written for doubles, too.
class BigFloat {
 public:
  BigFloat() = default;  ///< 0
  BigFloat(double x) {   // NOLINT(google-explicit-constructor): as a double would be
    arf_set_d(raw(), x);
  }
  /// Rounded to so many bits.
  BigFloat(const Rational& x, long bits);
  /// The midpoint of the ball.
  BigFloat(const RealBall& x, long bits);

  /// The integer next to 2ᵏ·x; of two, the even one.
  Integer scaled(long k) const;
  double to_double() const { return arf_get_d(raw(), ARF_RND_NEAR); }

  friend BigFloat operator+(const BigFloat& a, const BigFloat& b);
  friend BigFloat operator-(const BigFloat& a, const BigFloat& b);
  friend BigFloat operator-(const BigFloat& a);
  friend BigFloat operator*(const BigFloat& a, const BigFloat& b);
  friend BigFloat operator/(const BigFloat& a, const BigFloat& b);
  friend BigFloat sqrt(const BigFloat& a);
  friend bool operator<(const BigFloat& a, const BigFloat& b) {
    return arf_cmp(a.raw(), b.raw()) < 0;
  }
  friend bool operator==(const BigFloat& a, const BigFloat& b) {
    return arf_equal(a.raw(), b.raw()) != 0;
  }

 private:
  arf_struct* raw() { return handle_.get(); }
  const arf_struct* raw() const { return handle_.get(); }

  flint::Arf handle_;
  long bits_ = 53;
};

}  // namespace phrame
