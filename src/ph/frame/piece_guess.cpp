#include "phrame/ph/frame/piece_guess.hpp"

#include <cmath>
#include <vector>

namespace phrame::inline v0 {
namespace {

// Far more than allowed: what doubles lose, and B(0), which is not known here, make no difference.
constexpr double excess = 16;

/// The coefficients of 1, y, …, y^{length−1} over `unit`.
std::vector<double> coefficients(const BallPolynomial& p, const RealBall& unit, long length) {
  std::vector<double> c(static_cast<std::size_t>(length));
  for (long k = 0; k < std::min(length, p.degree_bound() + 1); ++k)
    c[static_cast<std::size_t>(k)] = approximate(divide(p.coefficient(k), unit, 53));
  return c;
}

/// Σ f[j]·g[n − j] from j = first on.
double term(const std::vector<double>& f, const std::vector<double>& g, std::size_t n,
            std::size_t first = 0) {
  double sum = 0;
  for (std::size_t j = first; j <= n; ++j) sum += f[j] * g[n - j];
  return sum;
}

}  // namespace

bool seems_too_long(const BallPolynomial& N, const BallPolynomial& D, const BallPolynomial& S,
                    const DoubleShape& shape) {
  const auto degree = static_cast<std::size_t>(shape.degree);
  const long length = shape.degree + 1;
  const RealBall unit = multiply(D.coefficient(0), sqrt(S.coefficient(0), 53), 53);
  const auto n = coefficients(N, unit, length);
  const auto d = coefficients(D, D.coefficient(0), length);
  const auto s = coefficients(S, S.coefficient(0), length);
  std::vector<double> w{1}, rate;  // S^(−1/2), of which 2SW′ = −S′W, and f′
  double size = 0;
  for (std::size_t k = 0; k <= degree; ++k) {
    const auto next = static_cast<double>(k + 1);
    rate.push_back(term(n, w, k) - term(d, rate, k, 1));
    if (k == degree) break;
    size += std::abs(rate.back()) / next;
    double slope = 0;
    for (std::size_t j = 1; j <= k + 1; ++j)
      slope -= s[j] * w[k + 1 - j] * (next - static_cast<double>(j) / 2);
    w.push_back(slope / next);
  }
  const double left_out = std::abs(rate.back()) / static_cast<double>(degree + 1);
  return left_out > excess * shape.goal * (size + 1);
}

bool seems_too_long(const BallPolynomial& sigma, const RotationRates& M, const DoubleShape& shape) {
  const auto degree = static_cast<std::size_t>(shape.degree);
  const long length = shape.degree + 1;
  const auto s = coefficients(sigma, sigma.coefficient(0), length);
  std::array<std::vector<double>, 4> m;
  for (std::size_t k = 0; k < 4; ++k) m[k] = coefficients(M[k], sigma.coefficient(0), length);
  const auto& [a, b, c, d] = m;
  std::array<std::vector<double>, 4> x, slope;  // B and B′
  for (auto& component : x) component.push_back(0.5);
  double size = 0, left_out = 0;
  for (std::size_t n = 0; n <= degree; ++n) {
    const auto& [u, v, p, q] = x;
    const std::array<double, 4> moved{-term(a, v, n) - term(b, p, n) - term(c, q, n),
                                      term(a, u, n) - term(c, p, n) + term(b, q, n),
                                      term(b, u, n) + term(c, v, n) - term(d, q, n),
                                      term(c, u, n) - term(b, v, n) + term(d, p, n)};
    size += left_out;
    left_out = 0;
    for (std::size_t k = 0; k < 4; ++k) {
      slope[k].push_back(moved[k] - term(s, slope[k], n, 1));
      x[k].push_back(slope[k].back() / static_cast<double>(n + 1));
      left_out += std::abs(x[k].back());
    }
  }
  return left_out > excess * shape.goal * (size + 1.0 / 64);
}

}  // namespace phrame
