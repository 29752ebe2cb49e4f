#include "phrame/ph/construct/preimage_grid.hpp"

#include <cmath>
#include <tuple>

#include "phrame/algebra/rounding.hpp"
#include "phrame/ph/construct/quintic_family.hpp"
#include "phrame/ph/frame/frame_angle.hpp"

namespace phrame {

Vector<Rational> exact(const Vector<Integer>& v, const Rational& scale) {
  return {v[0] * scale, v[1] * scale, v[2] * scale};
}

RationalQuaternion exact(const IntegerQuaternion& a, const Rational& scale) {
  return {a.u * scale, a.v * scale, a.p * scale, a.q * scale};
}

Vector<BigFloat> big_floats(const Vector<Rational>& v, long bits) {
  return {BigFloat(v[0], bits), BigFloat(v[1], bits), BigFloat(v[2], bits)};
}

Quaternion<BigFloat> big_floats(const RationalQuaternion& a, long bits) {
  return {{a.u, bits}, {a.v, bits}, {a.p, bits}, {a.q, bits}};
}

Phase phase_of(const Angle& angle, long bits) {
  // Quarters exactly: they keep planes.
  if (const auto z = direction_of(FrameAngle(angle)); z && (z->re == 0 || z->im == 0))
    return {BigFloat(static_cast<double>(z->re.sign())),
            BigFloat(static_cast<double>(z->im.sign()))};
  const auto [cos, sin] = cos_sin(to_real(angle).enclose(bits), bits);
  return {BigFloat(cos, bits), BigFloat(sin, bits)};
}

Rational rounded_to_places(const BigFloat& x, long k) {
  return Rational(x.scaled(k)) * power_of_two(-k);
}

RationalQuaternion rounded_to_places(const Quaternion<BigFloat>& a, long k) {
  return {rounded_to_places(a.u, k), rounded_to_places(a.v, k), rounded_to_places(a.p, k),
          rounded_to_places(a.q, k)};
}

Quaternion<double> in_doubles(const Quaternion<BigFloat>& a) {
  return {a.u.to_double(), a.v.to_double(), a.p.to_double(), a.q.to_double()};
}

PreimageGrid::PreimageGrid(long p, long bits)
    : p_(p), bits_(bits), step_(power_of_two(-p)), step2_(step_ * step_) {}

Quaternion<BigFloat> PreimageGrid::quaternion(const IntegerQuaternion& a,
                                              const Rational& step) const {
  return quaternion(exact(a, step));
}

IntegerQuaternion PreimageGrid::rounded(const Quaternion<BigFloat>& a) const {
  return {a.u.scaled(p_), a.v.scaled(p_), a.p.scaled(p_), a.q.scaled(p_)};
}

Phase turn_to(const Quaternion<BigFloat>& a, const Quaternion<BigFloat>& b) {
  return turn_to(a, b, sqrt(norm(a)));
}

Phase turn_to(const Quaternion<BigFloat>& a, const Quaternion<BigFloat>& b, const BigFloat& size) {
  const auto [re, im] =
      direction_of(hermitian_product(a, b), BigFloat(antiparallel) * size * sqrt(norm(b)));
  return {re, -im};
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

Rational squared_above(const Vector<Rational>& off, const Rational& tolerance) {
  if (off == Vector<Rational>{}) return 0;
  const long places = tolerance == 0 ? 0 : 21 - binary_exponent(tolerance);
  Integer sum;
  for (const Rational& x : off)
    if (x != 0) {
      const Integer n = floor(abs(x) * power_of_two(places)) + 1;
      sum += n * n;
    }
  return sum * power_of_two(-2 * places);
}

}  // namespace phrame
