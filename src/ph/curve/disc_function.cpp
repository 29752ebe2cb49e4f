#include "phrame/ph/curve/disc_function.hpp"

#include <algorithm>
#include <cmath>
#include <cstdlib>

namespace phrame::inline v0 {

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
  return constant_like(like, RealBall(c, like.bits));
}

DiscFunction constant_like(const DiscFunction& like, const RealBall& c) {
  return {BallPolynomial(std::vector<RealBall>{c}), absolute(c), like.length, like.bits};
}

// What is left out of the series is at most bound·(r/8)ⁿ/(1 − r/8), r/8 ≤ 1/2.
SizeBounds size_bounds(const DiscFunction& f, long radius) {
  constexpr long bits = 64;
  static_assert(outer_radius == 2 * inner_radius);
  const RealBall step(radius, bits);
  RealBall rest;
  RealBall power(1, bits);
  for (long k = 1; k < f.length; ++k) {
    power = multiply(power, step, bits);
    rest = add_product(rest, absolute(f.series.coefficient(k)), power, bits);
  }
  const RealBall middle = absolute(f.series.coefficient(0));
  const bool may_gain = sign(subtract(middle, rest, bits)) >= 0;
  const RealBall left_out = pow(RealBall(Rational(radius, outer_radius), bits), f.length, bits);
  rest = add_product(rest, times_power_of_two(f.bound, 1), left_out, bits);
  return {subtract(middle, rest, bits), add(middle, rest, bits), may_gain};
}

const SizeBounds& DiscFactor::size(long radius) const {
  return size_[static_cast<std::size_t>(radius - least_radius)].get(
      [this, radius] { return size_bounds(*base_, radius); });
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

std::optional<RealBall> bound_of_product(const DiscProduct& product, long radius,
                                         bool may_have_zeros) {
  constexpr long bits = 64;
  RealBall bound(1, bits);
  for (const DiscProduct::Factor& factor : product.factors) {
    const SizeBounds& size = factor.base.size(radius);
    const bool is_divisor = factor.half_exponents < 0;
    if ((is_divisor || !may_have_zeros) && sign(size.lower) <= 0) return std::nullopt;
    const long k = std::abs(factor.half_exponents);
    const RealBall power = pow(sqrt(is_divisor ? size.lower : size.upper, bits), k, bits);
    bound = is_divisor ? divide(bound, power, bits) : multiply(bound, power, bits);
  }
  bound = multiply(bound, size_bounds(product.numerator, radius).upper, bits);
  if (!bound.is_finite()) return std::nullopt;
  return bound;
}

}  // namespace

std::optional<RealBall> bound_on_inner_disc(const DiscProduct& product, long radius) {
  return bound_of_product(product, radius, false);
}

bool may_gain(const DiscProduct& product) {
  return std::all_of(product.factors.begin(), product.factors.end(),
                     [](const DiscProduct::Factor& factor) { return factor.base.size().may_gain; });
}

std::optional<RealBall> bound_with_zeros(const DiscProduct& product) {
  return bound_of_product(product, inner_radius, true);
}

BallPolynomial series(const DiscProduct& product) {
  BallPolynomial value = product.numerator.series;
  for (const DiscProduct::Factor& factor : product.factors)
    value = factor.base.times_power(value, factor.half_exponents);
  return value;
}

}  // namespace phrame
