#include "phrame/ph/smooth/rotation_series.hpp"

namespace phrame {
namespace {

/// w·x, quaternions.
std::array<RealBall, 4> turned_by(const std::array<RealBall, 3>& w,
                                  const std::array<RealBall, 4>& x, long bits) {
  const auto sum = [&](std::size_t i, int sign_i, std::size_t j, int sign_j, std::size_t k,
                       int sign_k) {
    RealBall value;
    const std::array<std::pair<std::size_t, int>, 3> terms{
        std::pair{i, sign_i}, {j, sign_j}, {k, sign_k}};
    for (std::size_t n = 0; n < 3; ++n) {
      const RealBall term = multiply(w[n], x[terms[n].first], bits);
      value = terms[n].second > 0 ? add(value, term, bits) : subtract(value, term, bits);
    }
    return value;
  };
  return {sum(1, -1, 2, -1, 3, -1), sum(0, 1, 3, 1, 2, -1), sum(3, -1, 0, 1, 1, 1),
          sum(2, 1, 1, -1, 0, 1)};
}

}  // namespace

QuaternionSeries rotation_series(const std::array<RealBall, 4>& at_zero,
                                 const Vector<BallPolynomial>& w, const BallPolynomial& sigma,
                                 long length, long bits) {
  std::vector<std::array<RealBall, 4>> b{at_zero};
  for (long n = 0; n + 1 < length; ++n) {
    std::array<RealBall, 4> next{};
    for (long j = 0; j <= n; ++j) {
      const auto turn = turned_by({w[0].coefficient(j), w[1].coefficient(j), w[2].coefficient(j)},
                                  b[static_cast<std::size_t>(n - j)], bits);
      const RealBall weight = multiply(RealBall(n - j, bits), sigma.coefficient(j + 1), bits);
      for (std::size_t k = 0; k < 4; ++k) {
        next[k] = add(next[k], turn[k], bits);
        next[k] =
            subtract(next[k], multiply(weight, b[static_cast<std::size_t>(n - j)][k], bits), bits);
      }
    }
    const RealBall over = multiply(RealBall(n + 1, bits), sigma.coefficient(0), bits);
    for (RealBall& x : next) x = divide(x, over, bits);
    b.push_back(next);
  }
  QuaternionSeries series;
  for (std::size_t k = 0; k < 4; ++k) {
    std::vector<RealBall> coefficients;
    for (const auto& of_y : b) coefficients.push_back(of_y[k]);
    series[k] = BallPolynomial(coefficients);
  }
  return series;
}

}  // namespace phrame
