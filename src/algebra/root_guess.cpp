#include "phrame/algebra/root_guess.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace phrame {
namespace {

using Complex = std::complex<double>;

Complex inverse(Complex z) { return std::conj(z) / std::norm(z); }

/// The coefficients over the power of 2 of the largest; those below 2⁻¹⁰⁷⁴ of it become 0.
std::vector<double> scaled_coefficients(const flint::FmpzPoly& f) {
  std::vector<double> mantissas;
  std::vector<slong> exponents;
  for (slong k = 0; k <= fmpz_poly_degree(f.get()); ++k) {
    slong exponent = 0;
    mantissas.push_back(fmpz_get_d_2exp(&exponent, fmpz_poly_get_coeff_ptr(f.get(), k)));
    exponents.push_back(exponent);
  }
  const slong largest = *std::max_element(exponents.begin(), exponents.end());
  for (std::size_t k = 0; k < mantissas.size(); ++k)
    mantissas[k] =
        std::ldexp(mantissas[k], static_cast<int>(std::max<slong>(exponents[k] - largest, -2000)));
  return mantissas;
}

/// Starting points on circles: the slopes of the upper convex hull of (k, log |c_k|) are about the
/// sizes of the roots (Bini 1996).
std::vector<Complex> starting_points(const std::vector<double>& c) {
  const auto height = [&](std::size_t k) { return std::log(std::abs(c[k])); };
  std::vector<std::size_t> hull;
  for (std::size_t k = 0; k < c.size(); ++k) {
    if (c[k] == 0) continue;
    const auto is_below = [&](std::size_t a, std::size_t b) {  // is b on or below the chord a – k?
      return (height(b) - height(a)) * static_cast<double>(k - a) <=
             (height(k) - height(a)) * static_cast<double>(b - a);
    };
    while (hull.size() >= 2 && is_below(hull[hull.size() - 2], hull.back())) hull.pop_back();
    hull.push_back(k);
  }
  std::vector<Complex> points;
  for (std::size_t edge = 1; edge < hull.size(); ++edge) {
    const auto count = static_cast<double>(hull[edge] - hull[edge - 1]);
    const double radius = std::exp((height(hull[edge - 1]) - height(hull[edge])) / count);
    for (std::size_t k = hull[edge - 1]; k < hull[edge]; ++k)
      points.push_back(std::polar(radius, 2 * std::numbers::pi * static_cast<double>(k) / count +
                                              0.7 * static_cast<double>(edge)));
  }
  return points;
}

/// f′(z)/f(z), by Horner's rule in z or, outside the unit circle, in 1/z.
Complex logarithmic_derivative(const std::vector<double>& c, Complex z) {
  const std::size_t n = c.size() - 1;
  const bool outside = std::norm(z) > 1;
  const Complex y = outside ? inverse(z) : z;
  Complex value = 0;
  Complex slope = 0;
  for (std::size_t k = 0; k <= n; ++k) {
    slope = slope * y + value;
    value = value * y + c[outside ? k : n - k];
  }
  const Complex quotient = slope * inverse(value);
  return outside ? (static_cast<double>(n) - y * quotient) * y : quotient;
}

}  // namespace

std::vector<Complex> guess_roots(const flint::FmpzPoly& f) {
  const std::vector<double> c = scaled_coefficients(f);
  if (c.front() == 0 || c.back() == 0) return {};
  std::vector<Complex> z = starting_points(c);
  constexpr int most_rounds = 100;
  for (int round = 0; round < most_rounds; ++round) {
    double largest_step = 0;
    for (std::size_t k = 0; k < z.size(); ++k) {
      Complex repulsion = 0;
      for (std::size_t j = 0; j < z.size(); ++j)
        if (j != k) repulsion += inverse(z[k] - z[j]);
      const Complex step = inverse(logarithmic_derivative(c, z[k]) - repulsion);
      if (!std::isfinite(step.real()) || !std::isfinite(step.imag())) continue;  // at a root
      z[k] -= step;
      largest_step = std::max(largest_step, std::norm(step) / std::norm(z[k]));
    }
    if (largest_step < 1e-26) return z;
  }
  return {};
}

}  // namespace phrame
