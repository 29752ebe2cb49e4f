#include "phrame/algebra/root_guess.hpp"

#include <algorithm>
#include <cmath>
#include <complex>
#include <limits>
#include <map>
#include <numbers>
#include <optional>

namespace phrame::inline v0 {
namespace {

using Complex = std::complex<double>;

/// mantissa · 2^scale, the mantissa of moderate size.
struct Approximation {
  Complex mantissa;
  long scale = 0;
  double last_step = 1;  ///< its square, relative
};

// Those of the standard library are slow, as they look after infinities.
Complex inverse(Complex z) { return std::conj(z) / std::norm(z); }
Complex product(Complex x, Complex y) {
  return {x.real() * y.real() - x.imag() * y.imag(), x.real() * y.imag() + x.imag() * y.real()};
}

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

  explicit Coefficients(const std::vector<double>& f) {
    for (const double c : f) {
      int exponent = 0;
      mantissas.push_back(std::frexp(c, &exponent));
      exponents.push_back(exponent);
    }
  }

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
std::vector<Approximation> starting_points(const Coefficients& c) {
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
  std::vector<Approximation> points;
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

/// f′(z)/f(z); no value where f(z) is not more than its rounding errors.
std::optional<Complex> logarithmic_derivative(const std::vector<double>& c, Complex z) {
  // By Horner's rule in z or, outside the unit circle, in 1/z.
  const std::size_t n = c.size() - 1;
  const bool outside = std::norm(z) > 1;
  const Complex y = outside ? inverse(z) : z;
  const double size = std::abs(y);
  Complex value = 0;
  Complex slope = 0;
  double bound = 0;
  for (std::size_t k = 0; k <= n; ++k) {
    const double coefficient = c[outside ? k : n - k];
    slope = product(slope, y) + value;
    value = product(value, y) + coefficient;
    bound = bound * size + std::abs(coefficient);
  }
  constexpr double rounding = 4 * std::numeric_limits<double>::epsilon();
  if (std::abs(value.real()) + std::abs(value.imag()) <= rounding * bound) return std::nullopt;
  const Complex quotient = product(slope, inverse(value));
  return outside ? product(static_cast<double>(n) - product(y, quotient), y) : quotient;
}

/// Of f with f(0) ≠ 0. Each root is written in the scale it starts from, so that roots of very
/// different sizes are found together: f is scaled anew for each of these sizes.
std::vector<Approximation> approximations(const Coefficients& coefficients) {
  std::vector<Approximation> roots = starting_points(coefficients);
  std::map<long, std::vector<double>> c;
  for (const Approximation& z : roots)
    if (!c.contains(z.scale)) c.emplace(z.scale, coefficients.in_scale(z.scale));

  std::vector<Approximation*> moving;
  for (Approximation& z : roots) moving.push_back(&z);
  constexpr int most_rounds = 100;
  for (int round = 0; round < most_rounds && !moving.empty(); ++round)
    std::erase_if(moving, [&](Approximation* z) {
      const auto ratio = logarithmic_derivative(c.at(z->scale), z->mantissa);
      if (!ratio) return true;
      Complex repulsion = 0;
      for (const Approximation& other : roots)
        if (&other != z)
          repulsion += inverse(z->mantissa - scaled(other.mantissa, other.scale - z->scale));
      const Complex step = inverse(*ratio - repulsion);
      if (!std::isfinite(step.real()) || !std::isfinite(step.imag())) return true;
      z->mantissa -= step;
      z->last_step = std::norm(step) / std::norm(z->mantissa);
      return z->last_step < 1e-26;
    });
  return roots;
}

}  // namespace

RootGuess guess_roots(const flint::FmpzPoly& f) {
  slong zeros = 0;
  while (fmpz_is_zero(fmpz_poly_get_coeff_ptr(f.get(), zeros)) != 0) ++zeros;
  RootGuess guess{std::vector<ComplexBall>(static_cast<std::size_t>(zeros)), 0};
  for (const auto& [z, scale, last_step] : approximations(Coefficients(f, zeros))) {
    ComplexBall& point = guess.points.emplace_back();
    acb_set_d_d(point.raw(), z.real(), z.imag());
    acb_mul_2exp_si(point.raw(), point.raw(), scale);
    if (last_step > 1e-10) ++guess.vague;
  }
  return guess;
}

std::vector<std::complex<double>> guess_roots(std::vector<double> f) {
  while (!f.empty() && f.back() == 0) f.pop_back();
  const auto first = std::ranges::find_if(f, [](double c) { return c != 0; });
  std::vector<Complex> roots(static_cast<std::size_t>(first - f.begin()));
  f.erase(f.begin(), first);
  if (f.empty()) return {};
  for (const Approximation& z : approximations(Coefficients(f)))
    roots.push_back(scaled(z.mantissa, z.scale));
  return roots;
}

}  // namespace phrame
