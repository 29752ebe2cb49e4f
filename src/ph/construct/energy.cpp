#include "phrame/ph/construct/energy.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "phrame/algebra/numerical_integral.hpp"
#include "phrame/integrate/pole_change.hpp"
#include "phrame/ph/along/totals.hpp"
#include "phrame/ph/curve/invariants.hpp"
#include "phrame/ph/curve/vector.hpp"

// With g = αβ′ − α′β: κ = 2|g|/(fσ²), ds = fσ dt.

namespace phrame::inline v0 {
namespace {

struct GaussPoint {
  double t;
  double weight;
};

/// Legendre's 10 points on [0, 1] [Abramowitz and Stegun, table 25.4].
constexpr std::array<GaussPoint, 5> half_of_points{{{0.1488743389816312, 0.2955242247147529},
                                                    {0.4333953941292472, 0.2692667193099963},
                                                    {0.6794095682990244, 0.2190863625159820},
                                                    {0.8650633666889845, 0.1494513491505806},
                                                    {0.9739065285171717, 0.0666713443086881}}};

double squared_size_of_g(const Quaternion<double>& a, const Quaternion<double>& slope) {
  const double re = a.u * slope.q - a.v * slope.p - (slope.u * a.q - slope.v * a.p);
  const double im = a.u * slope.p + a.v * slope.q - (slope.u * a.p + slope.v * a.q);
  return re * re + im * im;
}

/// ∫ F(t, σ, |g|²) dt from 0 to 1; ∞ where it is no number.
template <class F>
double integral(std::span<const Quaternion<double>> a, const F& integrand) {
  constexpr int panels = 8;
  const std::size_t m = a.size() - 1;
  if (m == 0) return 0;
  const auto rate = [&](double t) {
    std::array<Quaternion<double>, max_energy_degree + 1> b;  // by de Casteljau's algorithm
    std::copy(a.begin(), a.end(), b.begin());
    const double s = 1 - t;
    for (std::size_t n = m; n > 1; --n)
      for (std::size_t k = 0; k < n; ++k) b[k] = s * b[k] + t * b[k + 1];
    const Quaternion<double> slope = static_cast<double>(m) * (b[1] - b[0]);
    const Quaternion<double> value = s * b[0] + t * b[1];
    return integrand(t, norm(value), squared_size_of_g(value, slope));
  };
  double sum = 0;
  for (int k = 0; k < panels; ++k)
    for (const auto& [x, weight] : half_of_points)
      sum += weight * (rate((k + (1 - x) / 2) / panels) + rate((k + (1 + x) / 2) / panels));
  const double value = sum / (2 * panels);
  return std::isnan(value) ? std::numeric_limits<double>::infinity() : value;
}

double value_of(std::span<const double> f, double t) {
  std::array<double, max_energy_degree + 1> b;
  std::copy(f.begin(), f.end(), b.begin());
  for (std::size_t n = f.size() - 1; n > 0; --n)
    for (std::size_t k = 0; k < n; ++k) b[k] = (1 - t) * b[k] + t * b[k + 1];
  return b[0];
}

}  // namespace

double approximate_energy(std::span<const Quaternion<double>> a, std::span<const double> f) {
  return integral(a, [f](double t, double sigma, double gg) {
    return 4 * gg / (value_of(f, t) * sigma * sigma * sigma);
  });
}

double approximate_energy(std::span<const Quaternion<double>> a) {
  return integral(a,
                  [](double, double sigma, double gg) { return 4 * gg / (sigma * sigma * sigma); });
}

double approximate_turning(std::span<const Quaternion<double>> a) {
  return integral(a, [](double, double sigma, double gg) { return 2 * std::sqrt(gg) / sigma; });
}

namespace {

constexpr long wanted_bits = 26;

std::optional<RealBall> integral_by_quadrature(const Curve& curve, const Polynomial& bend,
                                               const Polynomial& size) {
  const auto rate = [&](const ComplexBall& t, long bits) {
    const ComplexBall s = evaluate(size, t, bits);
    const ComplexBall cube = multiply(s, multiply(s, s, bits), bits);
    return divide(evaluate(bend, t, bits),
                  multiply(evaluate(curve.multiplier(), t, bits), cube, bits), bits);
  };
  for (long bits = 32; bits <= 1024; bits *= 2) {
    const RealBall found =
        numerical_integral(rate, RealBall(), RealBall(1, bits), {bits, bits + 32, 50'000});
    if (!found.is_finite()) break;
    if (found.accuracy_bits() >= wanted_bits) return absolute(found);
  }
  return std::nullopt;
}

}  // namespace

// Over the poles, of which a spline has few on each segment; by quadrature in balls, which takes as
// many parts as a sharp bend needs; else in closed form.
std::optional<RealBall> proved_energy(const Curve& curve) {
  const Polynomial bend = rho(curve.preimage());
  const Polynomial size = sigma(curve.preimage());
  if (bend.is_zero()) return RealBall();
  if (curve.multiplier().is_constant())
    if (const auto found = pole_change({bend, {{curve.multiplier(), 1}, {size, 3}}}, wanted_bits))
      return absolute(found->whole(wanted_bits + 32));
  if (const auto found = integral_by_quadrature(curve, bend, size)) return found;
  const auto exact = bending_energy(curve);
  if (std::holds_alternative<Infinite>(exact)) return std::nullopt;
  return std::get<CurveTotal>(exact).value.enclose(1024);
}

}  // namespace phrame
