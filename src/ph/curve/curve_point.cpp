#include "phrame/ph/curve/curve_point.hpp"

#include <cstdlib>

#include "phrame/ph/curve/vector.hpp"

namespace phrame::inline v0 {

PointValue operator+(const PointValue& a, const PointValue& b) {
  return {add(a.value, b.value, a.bits), a.bits};
}

PointValue operator-(const PointValue& a, const PointValue& b) {
  return {subtract(a.value, b.value, a.bits), a.bits};
}

PointValue operator*(const PointValue& a, const PointValue& b) {
  return {multiply(a.value, b.value, a.bits), a.bits};
}

PointValue constant_like(const PointValue& like, const Rational& c) {
  return {RealBall(c, like.bits), like.bits};
}

PointValue constant_like(const PointValue& like, const RealBall& c) { return {c, like.bits}; }

RealBall value(const PointProduct& product) {
  const long bits = product.numerator.bits;
  RealBall times = product.numerator.value;
  std::optional<RealBall> by;
  const auto multiply_by = [&](const RealBall& x, bool is_divisor) {
    if (!is_divisor)
      times = multiply(times, x, bits);
    else
      by = by ? multiply(*by, x, bits) : x;
  };
  for (const auto& [factor, k] : product.factors) {
    const auto& [base, root] = factor;
    if (k % 2 != 0) multiply_by(root ? *root : sqrt_of_nonnegative(base.value, bits), k < 0);
    for (int rest = std::abs(k) / 2; rest > 0; --rest) multiply_by(base.value, k < 0);
  }
  return by ? divide(times, *by, bits) : times;
}

CurvePoint::CurvePoint(const ExpressionCurve& curve, const RealBall& t, const Rational& half,
                       long bits)
    : parameter_{t, bits} {
  const Vector<BallPolynomial> r = curve.series(t, half, 4, bits);
  const RealBall six(6, 4);
  for (std::size_t k = 0; k < 3; ++k) {
    derivatives_[0][k] = {r[k].coefficient(1), bits};
    derivatives_[1][k] = {times_power_of_two(r[k].coefficient(2), 1), bits};
    derivatives_[2][k] = {multiply(six, r[k].coefficient(3), bits), bits};
  }
  square_ = dot(first(), first());
  square_.root = sqrt_of_nonnegative(square_.base.value, bits);
  bend_ = cross(first(), second());
  bend_square_ = dot(bend_, bend_);
  volume_ = dot(bend_, third());
}

PointValue CurvePoint::inverse_speed() const {
  const long bits = parameter_.bits;
  return {divide(RealBall(1, 2), *square_.root, bits), bits};
}

}  // namespace phrame
