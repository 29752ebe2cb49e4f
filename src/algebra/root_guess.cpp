#include "phrame/algebra/root_guess.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <numbers>

namespace phrame {
namespace {

using Complex = std::complex<double>;

Complex inverse(Complex z) { return std::conj(z) / std::norm(z); }

/// x·2^exponent. Beyond 2^±400 the exponent is cut: so far away it makes no difference, and squares
/// stay finite.
double scaled(double x, slong exponent) {
  return std::ldexp(x, static_cast<int>(std::clamp<slong>(exponent, -400, 400)));
}
Complex scaled(Complex z, slong exponent) {
  if (exponent == 0) return z;
  return {scaled(z.real(), exponent), scaled(z.imag(), exponent)};
}

/// The coefficients of f, from the first that is not 0, as mantissas in ±[1/2, 1) or 0 times powers
/// of 2.
struct Coefficients {
  std::vector<double> mantissas;
  std::vector<slong> exponents;

  Coefficients(const flint::FmpzPoly& f, slong first) {
    for (slong k = first; k <= fmpz_poly_degree(f.get()); ++k) {
      slong exponent = 0;
      mantissas.push_back(fmpz_get_d_2exp(&exponent, fmpz_poly_get_coeff_ptr(f.get(), k)));
      exponents.push_back(exponent);
    }
  }

  double height(std::size_t k) const {  ///< log₂ |c_k|
    return std::log2(std::abs(mantissas[k])) + static_cast<double>(exponents[k]);
  }

  /// The coefficients of f(2^scale · w) over the largest; those below 2⁻¹⁰⁷⁴ of it become 0.
  std::vector<double> in_scale(slong scale) const {
    std::vector<slong> shifted = exponents;
    for (std::size_t k = 0; k < shifted.size(); ++k)
      shifted[k] = mantissas[k] == 0 ? std::numeric_limits<slong>::min() / 2
                                     : shifted[k] + scale * static_cast<slong>(k);
    const slong largest = *std::max_element(shifted.begin(), shifted.end());
    std::vector<double> c;
    for (std::size_t k = 0; k < shifted.size(); ++k)
      c.push_back(
          std::ldexp(mantissas[k], static_cast<int>(std::max<slong>(shifted[k] - largest, -2000))));
    return c;
  }
};

/// Starting points on circles: the slopes of the upper convex hull of (k, log |c_k|) are about the
/// sizes of the roots (Bini 1996).
std::vector<RootGuess> starting_points(const Coefficients& c) {
  std::vector<std::size_t> hull;
  for (std::size_t k = 0; k < c.mantissas.size(); ++k) {
    if (c.mantissas[k] == 0) continue;
    const auto is_below = [&](std::size_t a, std::size_t b) {  // is b on or below the chord a – k?
      return (c.height(b) - c.height(a)) * static_cast<double>(k - a) <=
             (c.height(k) - c.height(a)) * static_cast<double>(b - a);
    };
    while (hull.size() >= 2 && is_below(hull[hull.size() - 2], hull.back())) hull.pop_back();
    hull.push_back(k);
  }
  std::vector<RootGuess> points;
  for (std::size_t edge = 1; edge < hull.size(); ++edge) {
    const auto count = static_cast<double>(hull[edge] - hull[edge - 1]);
    const double size = (c.height(hull[edge - 1]) - c.height(hull[edge])) / count;
    const double scale = std::round(size);
    for (std::size_t k = hull[edge - 1]; k < hull[edge]; ++k)
      points.push_back({std::polar(std::exp2(size - scale),
                                   2 * std::numbers::pi * static_cast<double>(k) / count +
                                       0.7 * static_cast<double>(edge)),
                        static_cast<long>(scale)});
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

// Each root is written in the scale it starts from, so that roots of very different sizes are found
// together: f is scaled anew for each of these sizes.
std::vector<RootGuess> guess_roots(const flint::FmpzPoly& f) {
  slong zeros = 0;
  while (fmpz_is_zero(fmpz_poly_get_coeff_ptr(f.get(), zeros)) != 0) ++zeros;
  const Coefficients coefficients(f, zeros);
  std::vector<RootGuess> roots = starting_points(coefficients);
  std::map<long, std::vector<double>> c;
  for (const RootGuess& z : roots)
    if (!c.contains(z.scale)) c.emplace(z.scale, coefficients.in_scale(z.scale));

  constexpr int most_rounds = 100;
  for (int round = 0; round < most_rounds; ++round) {
    double largest_step = 0;
    for (RootGuess& z : roots) {
      Complex repulsion = 0;
      for (const RootGuess& other : roots)
        if (&other != &z)
          repulsion += inverse(z.mantissa - scaled(other.mantissa, other.scale - z.scale));
      const Complex step = inverse(logarithmic_derivative(c.at(z.scale), z.mantissa) - repulsion);
      if (!std::isfinite(step.real()) || !std::isfinite(step.imag())) continue;  // at a root
      z.mantissa -= step;
      largest_step = std::max(largest_step, std::norm(step) / std::norm(z.mantissa));
    }
    if (largest_step < 1e-26) {
      roots.insert(roots.end(), static_cast<std::size_t>(zeros), RootGuess{});
      return roots;
    }
  }
  return {};
}

}  // namespace phrame
