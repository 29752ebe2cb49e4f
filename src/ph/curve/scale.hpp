#pragma once
#include <vector>

#include "phrame/ph/curve/quaternion.hpp"

namespace phrame::inline v0 {

/// @{ f of each part.
template <class T, class F>
auto each(const Vector<T>& v, const F& f) {
  return Vector<decltype(f(v[0]))>{f(v[0]), f(v[1]), f(v[2])};
}
template <class T, class F>
auto each(const Quaternion<T>& a, const F& f) {
  return Quaternion<decltype(f(a.u))>{f(a.u), f(a.v), f(a.p), f(a.q)};
}
/// @}

/// The greatest |coordinate|.
Rational largest(const Vector<Rational>& v);
Rational largest(const std::vector<Vector<Rational>>& list);

/// A power of 4 that brings numbers of that size, > 0, to between 1/4 and 4; 1 for 0.
Rational scale_for_doubles(const Rational& size);
/// c·v in doubles.
Vector<double> scaled_to_doubles(const Rational& c, const Vector<Rational>& v);
/// @{ The same numbers.
Quaternion<double> quaternion_in_doubles(const RationalQuaternion& a);
RationalQuaternion exact_quaternion(const Quaternion<double>& a);
/// @}

/// x > 0 to so many significant bits.
Rational rounded_to_bits(const Rational& x, long bits);
/// @{ |v| > 0 and √|v|, in doubles, to so many significant bits, at most 50.
Rational rounded_length(const Vector<Rational>& v, long bits);
Rational rounded_root_of_length(const Vector<Rational>& v, long bits);
/// @}
/// The multiple of 2^−k next to x.
Rational rounded_to_places(const Rational& x, long k);
/// The same of each part.
RationalQuaternion rounded_to_places(const RationalQuaternion& a, long k);

/// The square of the sine of the angle between them; 1 where that is not acute.
Rational squared_sine(const Vector<Rational>& a, const Vector<Rational>& b);

/// An upper bound of √x for x ≥ 0, greater by less than a 2^−30th; √0 = 0.
Rational square_root_above(const Rational& x);

}  // namespace phrame
