#include "phrame/ph/twist/twist_search.hpp"

#include <nlopt.h>

#include <algorithm>
#include <boost/math/tools/minima.hpp>
#include <cmath>
#include <complex>
#include <iterator>
#include <memory>
#include <span>

namespace phrame::inline v0 {
namespace {

using Complex = std::complex<double>;

/// Parameters to try with this sign of γ, ascending: in powers of 2 from where w(1/2) is nearest to
/// 0, in units of its distance there, and from where γ = 0. Empty where there are few.
std::vector<double> samples_on(const RotationFamily& family, int sign_of_gamma) {
  const auto at_half = [](const Rotation& w) {
    const RealBall half(Rational(1, 2), 64);
    return Complex(approximate(evaluate(w.a, half, 64)), approximate(evaluate(w.b, half, 64)));
  };
  const Complex p = at_half(family.basis[0]);
  const Complex q = at_half(family.basis[1]);
  const Complex aligned = std::conj(q) * p;
  const double foot = -std::real(aligned) / std::norm(q);
  double unit = std::abs(std::imag(aligned)) / std::norm(q);
  if (unit < 1e-6 * std::abs(p) / std::abs(q)) unit = std::abs(p) / std::abs(q);

  const double gamma = approximate(family.end_factor[0]);
  const double slope = approximate(family.end_factor[1]);
  std::vector<double> samples;
  const auto add_sample = [&](double x) {
    if ((gamma + slope * x) * sign_of_gamma > 0) samples.push_back(x);
  };
  add_sample(foot);
  for (double step = unit / 8; step < 3000 * unit; step *= 2) {
    add_sample(foot + step);
    add_sample(foot - step);
    if (slope != 0) add_sample((sign_of_gamma * step / unit / 64 - gamma) / slope);
  }
  if (samples.size() < 3) return {};
  std::sort(samples.begin(), samples.end());
  return samples;
}

/// The minimum between left and right: Brent's method, and Newton's as long as it helps. The
/// objective is resolved there.
template <class Value>
double minimum_between(TwistObjective& objective, const Value& value, double left, double right) {
  const auto brent = [&] {
    std::uintmax_t steps = 60;
    double x = boost::math::tools::brent_find_minima(value, left, right, 26, steps).first;
    objective.resolve(std::span(&x, 1));
    return x;
  };
  double x = brent();
  const auto [slope, convexity] = objective.derivatives(x);
  if (!(std::abs(slope) < 1e-4 * convexity * (right - left)))
    x = brent();  // misled by coarse values
  const auto coarse = [&](double p) { return objective(std::span(&p, 1)); };
  for (int k = 0; k < 4; ++k) {
    const auto [first, second] = objective.derivatives(x);
    const double next = x - first / second;
    if (!(second > 0) || !(next > left) || !(next < right)) break;
    if (!(coarse(next) <= coarse(x) * (1 + 1e-12))) break;
    x = next;
  }
  return x;
}

}  // namespace

std::optional<LineGuess> search_line(TwistObjective& objective, int sign_of_gamma) {
  const auto samples = samples_on(objective.family(), sign_of_gamma);
  if (samples.empty()) return std::nullopt;
  const auto refine_around = [&](double x) { objective.resolve(std::span(&x, 1)); };
  const auto coarse = [&](double x) { return objective(std::span(&x, 1)); };
  const auto value = [&](double x) {
    if (const double here = coarse(x); here < HUGE_VAL) return here;
    refine_around(x);
    return coarse(x);
  };
  const double inside = samples[samples.size() / 2];
  objective.expect_turn_of(std::span(&inside, 1));
  std::vector<double> values;
  std::transform(samples.begin(), samples.end(), std::back_inserter(values), coarse);
  const auto least = [&] {
    return static_cast<std::size_t>(std::min_element(values.begin(), values.end()) -
                                    values.begin());
  };
  std::size_t best = least();
  const auto is_known = [&](std::size_t k) { return k >= values.size() || values[k] < HUGE_VAL; };
  if (!is_known(best) || !is_known(best - 1) || !is_known(best + 1)) {
    std::transform(samples.begin(), samples.end(), values.begin(), value);
    best = least();
  }
  if (values[best] == HUGE_VAL) return std::nullopt;
  const bool is_interior = best > 0 && best + 1 < samples.size();
  double x = samples[best];
  if (is_interior)
    x = minimum_between(objective, value, samples[best - 1], samples[best + 1]);
  else
    refine_around(x);
  const double least_value = value(x);
  if (least_value == HUGE_VAL) return std::nullopt;
  return LineGuess{x, least_value, objective.derivatives(x).second, is_interior};
}

std::vector<double> search(TwistObjective& objective, std::vector<double> start) {
  const auto evaluate_at = [](unsigned n, const double* x, double* gradient, void* data) {
    const auto& function = *static_cast<const TwistObjective*>(data);
    const double value =
        function({x, n}, gradient == nullptr ? std::span<double>{} : std::span(gradient, n));
    return std::isfinite(value) ? value : 1e300;
  };
  objective.expect_turn_of(start);
  objective.resolve(start);
  std::vector<double> best = start;
  double least = objective(start);
  // The quadrature is made for the start; where the search goes far from it, once more.
  for (int round = 0; round < 3; ++round) {
    const std::unique_ptr<nlopt_opt_s, void (*)(nlopt_opt)> optimizer(
        nlopt_create(NLOPT_LD_SLSQP, static_cast<unsigned>(start.size())), nlopt_destroy);
    nlopt_set_min_objective(optimizer.get(), evaluate_at, &objective);
    nlopt_set_ftol_rel(optimizer.get(), 1e-13);
    nlopt_set_maxeval(optimizer.get(), 400);
    double value = 0;
    nlopt_optimize(optimizer.get(), start.data(), &value);
    objective.resolve(start);
    value = objective(start);
    if (!(value < least)) break;
    const bool is_settled = value > least * (1 - 1e-9);
    least = value;
    best = start;
    if (is_settled) break;
  }
  return best;
}

}  // namespace phrame
