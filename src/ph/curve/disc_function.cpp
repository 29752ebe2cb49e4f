#include "phrame/ph/curve/disc_function.hpp"

#include <algorithm>
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
  RealBall rest;
  RealBall power(1, bits);
  for (long k = 1; k < f.length; ++k) {
    power = multiply(power, RealBall(inner_radius, bits), bits);
    rest = add_product(rest, absolute(f.series.coefficient(k)), power, bits);
  }
  const RealBall middle = absolute(f.series.coefficient(0));
  const bool may_gain = sign(subtract(middle, rest, bits)) >= 0;
  rest = add(rest, times_power_of_two(f.bound, 1 - f.length), bits);
  return {subtract(middle, rest, bits), add(middle, rest, bits), may_gain};
}

const SizeBounds& DiscFactor::size() const {
  return size_.get([this] { return size_bounds(*base_); });
}

const BallPolynomial& DiscFactor::root() const {
  return root_.get([this] {
    return multiply_series(base_->series, inverse_root(), base_->length, base_->bits);
  });
}

const BallPolynomial& DiscFactor::inverse_root() const {
  return inverse_root_.get(
      [this] { return inverse_sqrt_series(base_->series, base_->length, base_->bits); });
}

const BallPolynomial& DiscFactor::inverse() const {
  return inverse_.get([this] {
    const BallPolynomial one(std::vector<RealBall>{RealBall(1, base_->bits)});
    return divide_series(one, base_->series, base_->length, base_->bits);
  });
}

BallPolynomial DiscFactor::times_power(const BallPolynomial& p, int k) const {
  const auto& [series, bound, length, bits] = *base_;
  BallPolynomial product = p;
  if (k % 2 != 0) product = multiply_series(product, k > 0 ? root() : inverse_root(), length, bits);
  for (int rest = std::abs(k) / 2; rest > 0; --rest)
    product = multiply_series(product, k > 0 ? series : inverse(), length, bits);
  return product;
}

namespace {

std::optional<RealBall> bound_of_product(const DiscProduct& product, bool may_have_zeros) {
  constexpr long bits = 64;
  RealBall bound = size_bounds(product.numerator).upper;
  for (const DiscProduct::Factor& factor : product.factors) {
    const SizeBounds& size = factor.base.size();
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

bool may_gain(const DiscProduct& product) {
  return std::all_of(product.factors.begin(), product.factors.end(),
                     [](const DiscProduct::Factor& factor) { return factor.base.size().may_gain; });
}

std::optional<RealBall> bound_with_zeros(const DiscProduct& product) {
  return bound_of_product(product, true);
}

BallPolynomial series(const DiscProduct& product) {
  BallPolynomial value = product.numerator.series;
  for (const DiscProduct::Factor& factor : product.factors)
    value = factor.base.times_power(value, factor.half_exponents);
  return value;
}

}  // namespace phrame
