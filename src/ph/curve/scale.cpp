#include "phrame/ph/curve/scale.hpp"

#include <algorithm>
#include <cmath>

#include "phrame/algebra/rounding.hpp"
#include "phrame/ph/curve/vector.hpp"

namespace phrame::inline v0 {

Rational largest(const Vector<Rational>& v) { return std::max({abs(v[0]), abs(v[1]), abs(v[2])}); }

Rational largest(const std::vector<Vector<Rational>>& list) {
  Rational size;
  for (const Vector<Rational>& v : list) size = std::max(size, largest(v));
  return size;
}

Rational scale_for_doubles(const Rational& size) {
  if (size == 0) return 1;
  const long e = binary_exponent(size);
  return power_of_two(-(e - (e & 1)));
}

Vector<double> scaled_to_doubles(const Rational& c, const Vector<Rational>& v) {
  return each(v, [&](const Rational& x) { return static_cast<double>(c * x); });
}

Quaternion<double> quaternion_in_doubles(const RationalQuaternion& a) {
  return each(a, [](const Rational& x) { return static_cast<double>(x); });
}

RationalQuaternion exact_quaternion(const Quaternion<double>& a) { return each(a, exact_rational); }

Rational rounded_to_places(const Rational& x, long k) {
  return Rational(floor(x * power_of_two(k) + Rational(1, 2))) * power_of_two(-k);
}

RationalQuaternion rounded_to_places(const RationalQuaternion& a, long k) {
  return each(a, [k](const Rational& x) { return rounded_to_places(x, k); });
}

Rational rounded_to_bits(const Rational& x, long bits) {
  return rounded_to_places(x, bits - binary_exponent(x));
}

Rational rounded_length(const Vector<Rational>& v, long bits) {
  const Rational scale = scale_for_doubles(largest(v));
  const Vector<double> w = scaled_to_doubles(scale, v);
  return rounded_to_bits(exact_rational(std::sqrt(dot(w, w))), bits) / scale;
}

Rational rounded_root_of_length(const Vector<Rational>& v, long bits) {
  const Rational length = rounded_length(v, 50);
  const Rational scale = scale_for_doubles(length);
  const double root = std::sqrt(static_cast<double>(scale * length));
  return rounded_to_bits(exact_rational(root), bits) / *square_root(scale);
}

Rational squared_sine(const Vector<Rational>& a, const Vector<Rational>& b) {
  const Rational ab = dot(a, b);
  if (ab <= 0) return 1;
  const Rational sizes = dot(a, a) * dot(b, b);
  return (sizes - ab * ab) / sizes;
}

Rational square_root_above(const Rational& x) {
  if (x == 0) return 0;
  const long half = 32 - binary_exponent(x) / 2;  // x·4^half has 63 bits at least
  return Rational(sqrt(floor(x * power_of_two(2 * half))) + 1) * power_of_two(-half);
}

}  // namespace phrame
