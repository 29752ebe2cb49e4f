#pragma once
#include "phrame/algebra/angle.hpp"
#include "phrame/algebra/big_float.hpp"
#include "phrame/algebra/gaussian_integer.hpp"
#include "phrame/ph/construct/preimage.hpp"

namespace phrame {

// Preimages that are rounded to multiples of 2^−p, and what the numbers before are called.

using IntegerQuaternion = Quaternion<Integer>;
/// cos ψ + i·sin ψ, about.
using Phase = ComplexOf<BigFloat>;

/// @{ Times `scale`.
Vector<Rational> exact(const Vector<Integer>& v, const Rational& scale);
RationalQuaternion exact(const IntegerQuaternion& a, const Rational& scale);
/// @}

/// @{ With so many bits.
Vector<BigFloat> big_floats(const Vector<Rational>& v, long bits);
Quaternion<BigFloat> big_floats(const RationalQuaternion& a, long bits);
Phase phase_of(const Angle& angle, long bits);
/// @}

/// @{ Rounded to multiples of 2^−k.
Rational rounded_to_places(const BigFloat& x, long k);
RationalQuaternion rounded_to_places(const Quaternion<BigFloat>& a, long k);
/// @}
Quaternion<double> in_doubles(const Quaternion<BigFloat>& a);

/// The rounding to multiples of 2^−p, and the precision that it needs.
class PreimageGrid {
 public:
  PreimageGrid(long p, long bits);

  const Rational& step() const { return step_; }
  const Rational& step2() const { return step2_; }
  BigFloat number(const Rational& x) const { return {x, bits_}; }
  Vector<BigFloat> vector(const Vector<Rational>& v) const { return big_floats(v, bits_); }
  Quaternion<BigFloat> quaternion(const RationalQuaternion& a) const {
    return big_floats(a, bits_);
  }
  Quaternion<BigFloat> quaternion(const IntegerQuaternion& a, const Rational& step) const;
  IntegerQuaternion rounded(const Quaternion<BigFloat>& a) const;
  Phase phase(const Angle& angle) const { return phase_of(angle, bits_); }

 private:
  long p_;
  long bits_;
  Rational step_;
  Rational step2_;
};

/// @{ What turns b such that H(a, b) becomes positive; 1 where H is 0, or rounding beside |b| and
/// the size of a, or of the terms that a is a sum of: these may cancel.
Phase turn_to(const Quaternion<BigFloat>& a, const Quaternion<BigFloat>& b);
Phase turn_to(const Quaternion<BigFloat>& a, const Quaternion<BigFloat>& b, const BigFloat& size);
/// @}

/// z with |z| an integer, near e^{iψ} times that, with short numbers: (1 + iτ)² and quarters.
GaussianInteger short_direction(const Phase& wanted);

/// Of a difference, an upper bound of its square, and 0 of 0. A coordinate counts for more than it
/// is by less than a 2^−20th of the tolerance: so the numbers are short, for there are many.
Rational squared_above(const Vector<Rational>& off, const Rational& tolerance);

}  // namespace phrame
