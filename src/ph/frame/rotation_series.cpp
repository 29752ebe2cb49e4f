#include "phrame/ph/frame/rotation_series.hpp"

#include "phrame/algebra/ball_series.hpp"

namespace phrame::inline v0 {
namespace {

/// The coefficient of yⁿ in w·b, quaternions.
std::array<RealBall, 4> turned_by(const Vector<BallPolynomial>& w, const QuaternionSeries& b,
                                  long n, long bits) {
  const auto product = [&](std::size_t i, std::size_t k) {
    return coefficient_of_product(w[i], b[k], n, bits);
  };
  const auto plus = [bits](const RealBall& x, const RealBall& y) { return add(x, y, bits); };
  const auto minus = [bits](const RealBall& x, const RealBall& y) { return subtract(x, y, bits); };
  return {minus({}, plus(product(0, 1), plus(product(1, 2), product(2, 3)))),
          plus(product(0, 0), minus(product(1, 3), product(2, 2))),
          plus(minus(product(1, 0), product(0, 3)), product(2, 1)),
          plus(minus(product(0, 2), product(1, 1)), product(2, 0))};
}

/// p without its constant coefficient, over y.
BallPolynomial without_constant(const BallPolynomial& p) {
  std::vector<RealBall> rest;
  for (long k = 1; k <= p.degree_bound(); ++k) rest.push_back(p.coefficient(k));
  return BallPolynomial(rest);
}

}  // namespace

QuaternionSeries rotation_series(const std::array<RealBall, 4>& at_zero,
                                 const Vector<BallPolynomial>& w, const BallPolynomial& sigma,
                                 long length, long bits) {
  const BallPolynomial rest = without_constant(sigma);
  QuaternionSeries b;
  QuaternionSeries y_slope;  // yB′
  for (std::size_t k = 0; k < 4; ++k) set_coefficient(b[k], 0, at_zero[k]);
  for (long n = 0; n + 1 < length; ++n) {
    const auto turn = turned_by(w, b, n, bits);
    const RealBall count(n + 1, bits);
    const RealBall over = multiply(count, sigma.coefficient(0), bits);
    for (std::size_t k = 0; k < 4; ++k) {
      const RealBall sum =
          subtract(turn[k], coefficient_of_product(rest, y_slope[k], n, bits), bits);
      const RealBall next = divide(sum, over, bits);
      set_coefficient(b[k], n + 1, next);
      set_coefficient(y_slope[k], n + 1, multiply(count, next, bits));
    }
  }
  return b;
}

}  // namespace phrame
