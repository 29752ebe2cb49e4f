#include "phrame/ph/construct/preimage_grid.hpp"

#include <cmath>
#include <tuple>

#include "phrame/algebra/in_place.hpp"
#include "phrame/algebra/rounding.hpp"
#include "phrame/ph/along/frame_angle.hpp"
#include "phrame/ph/construct/quintic_family.hpp"

namespace phrame::inline v0 {

Vector<Rational> exact(const Vector<Integer>& v, const Rational& scale) {
  return each(v, [&](const Integer& x) { return x * scale; });
}

RationalQuaternion exact(const IntegerQuaternion& a, const Rational& scale) {
  return each(a, [&](const Integer& x) { return x * scale; });
}

void include_denominators(Integer& d, const RationalQuaternion& a) {
  for (const Rational* x : {&a.u, &a.v, &a.p, &a.q}) include_denominator(d, *x);
}

IntegerQuaternion whole_multiple(const RationalQuaternion& a, const Integer& d) {
  return each(a, [&](const Rational& x) { return whole_multiple(x, d); });
}

Vector<BigFloat> big_floats(const Vector<Rational>& v, long bits) {
  return each(v, [bits](const Rational& x) { return BigFloat(x, bits); });
}

FloatQuaternion big_floats(const RationalQuaternion& a, long bits) {
  return each(a, [bits](const Rational& x) { return BigFloat(x, bits); });
}

FloatQuaternion unit_preimage(const Vector<Rational>& d, long bits) {
  const Vector<BigFloat> v = big_floats(scale_for_doubles(largest(d)) * d, bits);
  return preimage((BigFloat(1.0) / sqrt(dot(v, v))) * v);
}

Phase phase_of(const Angle& angle, long bits) {
  // Quarters exactly: they keep planes.
  if (const auto z = direction_of(FrameAngle(angle)); z && (z->re == 0 || z->im == 0))
    return {BigFloat(static_cast<double>(z->re.sign())),
            BigFloat(static_cast<double>(z->im.sign()))};
  const auto [cos, sin] = cos_sin(to_real(angle).enclose(bits), bits);
  return {BigFloat(cos, bits), BigFloat(sin, bits)};
}

Rational rounded_to_places(const BigFloat& x, long k) { return over_power_of_two(x.scaled(k), k); }

RationalQuaternion rounded_to_places(const FloatQuaternion& a, long k) {
  return each(a, [k](const BigFloat& x) { return rounded_to_places(x, k); });
}

IntegerQuaternion rounded_multiple(const FloatQuaternion& a, long k) {
  return each(a, [k](const BigFloat& x) { return x.scaled(k); });
}

Quaternion<double> in_doubles(const FloatQuaternion& a) {
  return each(a, [](const BigFloat& x) { return x.to_double(); });
}

Phase turn_to(const FloatQuaternion& a, const FloatQuaternion& b) {
  return turn_to(a, b, sqrt(norm(a)));
}

Phase turn_to(const FloatQuaternion& a, const FloatQuaternion& b, const BigFloat& size) {
  return conjugate(
      direction_of(hermitian_product(a, b), BigFloat(antiparallel) * size * sqrt(norm(b))));
}

GaussianInteger short_direction(const Phase& wanted) {
  constexpr long bits = 1024;  // off by less than a 2000th of a radian
  double re = wanted.re.to_double();
  double im = wanted.im.to_double();
  long quarters = 0;
  for (; re < std::abs(im); ++quarters) std::tie(re, im) = std::pair(im, -re);
  const Rational tau = exact_rational(im / (re + std::hypot(re, im)));
  const Rational short_tau = simplest_between(tau - Rational(1, bits), tau + Rational(1, bits));
  GaussianInteger root{denominator(short_tau), numerator(short_tau)};
  GaussianInteger z = root * root;
  for (; quarters > 0; --quarters) z = {-z.im, z.re};
  return z;
}

}  // namespace phrame
