#pragma once
#include "phrame/algebra/angle.hpp"
#include "phrame/algebra/big_float.hpp"
#include "phrame/algebra/gaussian_integer.hpp"
#include "phrame/ph/construct/preimage.hpp"
#include "phrame/ph/curve/scale.hpp"

namespace phrame::inline v0 {

// Preimages that are rounded to multiples of 2^−p, and what the numbers before are called.

using IntegerQuaternion = Quaternion<Integer>;
using FloatQuaternion = Quaternion<BigFloat>;
/// cos ψ + i·sin ψ, about.
using Phase = ComplexOf<BigFloat>;

/// @{ Times `scale`.
Vector<Rational> exact(const Vector<Integer>& v, const Rational& scale);
RationalQuaternion exact(const IntegerQuaternion& a, const Rational& scale);
/// @}

/// d becomes a multiple of the denominators of `a`, too, the least one.
void include_denominators(Integer& d, const RationalQuaternion& a);
/// d·a, for a multiple d of its denominators.
IntegerQuaternion whole_multiple(const RationalQuaternion& a, const Integer& d);

/// @{ With so many bits.
Vector<BigFloat> big_floats(const Vector<Rational>& v, long bits);
FloatQuaternion big_floats(const RationalQuaternion& a, long bits);
Phase phase_of(const Angle& angle, long bits);
/// @}
/// A preimage of the direction of d ≠ 0, of size 1.
FloatQuaternion unit_preimage(const Vector<Rational>& d, long bits);

/// @{ Rounded to multiples of 2^−k.
Rational rounded_to_places(const BigFloat& x, long k);
RationalQuaternion rounded_to_places(const FloatQuaternion& a, long k);
/// @}
/// 2ᵏ·a, rounded.
IntegerQuaternion rounded_multiple(const FloatQuaternion& a, long k);
Quaternion<double> in_doubles(const FloatQuaternion& a);

/// @{ What turns b such that H(a, b) becomes positive; 1 where H is 0, or rounding beside |b| and
/// the size of a, or of the terms that a is a sum of: these may cancel.
Phase turn_to(const FloatQuaternion& a, const FloatQuaternion& b);
Phase turn_to(const FloatQuaternion& a, const FloatQuaternion& b, const BigFloat& size);
/// @}

/// z with |z| an integer, near e^{iψ} times that, with short numbers: (1 + iτ)² and quarters.
GaussianInteger short_direction(const Phase& wanted);

}  // namespace phrame
