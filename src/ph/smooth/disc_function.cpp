#include "phrame/ph/smooth/disc_function.hpp"

#include <cmath>
#include <cstdlib>

namespace phrame {

DiscFunction operator+(const DiscFunction& f, const DiscFunction& g) {
  return {add(f.series, g.series, f.bits), add(f.bound, g.bound, 64), f.length, f.bits};
}

DiscFunction operator-(const DiscFunction& f, const DiscFunction& g) {
  return {subtract(f.series, g.series, f.bits), add(f.bound, g.bound, 64), f.length, f.bits};
}

DiscFunction operator*(const DiscFunction& f, const DiscFunction& g) {
  return {multiply_series(f.series, g.series, f.length, f.bits), multiply(f.bound, g.bound, 64),
          f.length, f.bits};
}

DiscFunction constant_like(const DiscFunction& like, const Rational& c) {
  const RealBall value(c, like.bits);
  return {BallPolynomial(std::vector<RealBall>{value}), absolute(value), like.length, like.bits};
}

SizeBounds size_bounds(const DiscFunction& f) {
  constexpr long bits = 64;
  static_assert(outer_radius == 2 * inner_radius);
  RealBall rest = times_power_of_two(f.bound, 1 - f.length);
  RealBall power(1, bits);
  for (long k = 1; k < f.length; ++k) {
    power = multiply(power, RealBall(inner_radius, bits), bits);
    rest = add_product(rest, absolute(f.series.coefficient(k)), power, bits);
  }
  const RealBall middle = absolute(f.series.coefficient(0));
  return {subtract(middle, rest, bits), add(middle, rest, bits)};
}

namespace {

std::optional<RealBall> bound_of_product(const DiscProduct& product, bool may_have_zeros) {
  constexpr long bits = 64;
  RealBall bound = size_bounds(product.numerator).upper;
  for (const DiscProduct::Factor& factor : product.factors) {
    const SizeBounds size = size_bounds(factor.base);
    const bool is_divisor = factor.half_exponents < 0;
    if ((is_divisor || !may_have_zeros) && sign(size.lower) <= 0) return std::nullopt;
    const long k = std::abs(factor.half_exponents);
    const RealBall power = pow(sqrt(is_divisor ? size.lower : size.upper, bits), k, bits);
    bound = is_divisor ? divide(bound, power, bits) : multiply(bound, power, bits);
  }
  if (!bound.is_finite()) return std::nullopt;
  return bound;
}

}  // namespace

std::optional<RealBall> bound_on_inner_disc(const DiscProduct& product) {
  return bound_of_product(product, false);
}

std::optional<RealBall> bound_with_zeros(const DiscProduct& product) {
  return bound_of_product(product, true);
}

BallPolynomial series(const DiscProduct& product) {
  const long length = product.numerator.length;
  const long bits = product.numerator.bits;
  BallPolynomial value = product.numerator.series;
  for (const DiscProduct::Factor& factor : product.factors) {
    const BallPolynomial& base = factor.base.series;
    int k = factor.half_exponents;
    if (k % 2 != 0) {
      value = multiply_series(value, inverse_sqrt_series(base, length, bits), length, bits);
      ++k;
    }
    const auto size = static_cast<unsigned long>(std::abs(k) / 2);
    if (size == 0) continue;
    const BallPolynomial power = size == 1 ? base : pow_series(base, size, length, bits);
    value = k > 0 ? multiply_series(value, power, length, bits)
                  : divide_series(value, power, length, bits);
  }
  return value;
}

}  // namespace phrame
