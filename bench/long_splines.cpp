// Splines of many segments, from what a file says to a number of 17 digits, all found anew; and
// beside them what is not to be avoided: the same integral by Gauss's rule in doubles, without a
// proof.
#include <benchmark/benchmark.h>
#include <fmt/format.h>

#include <cmath>

#include "curves.hpp"
#include "phrame/algebra/rounding.hpp"
#include "phrame/answer/angle.hpp"
#include "phrame/answer/info.hpp"
#include "phrame/answer/totals.hpp"
#include "phrame/ph/construct/hermite_spline.hpp"
#include "phrame/ph/construct/quintic_spline.hpp"

namespace phrame::inline v0::bench {
namespace {

using State = benchmark::State;
using Point = std::array<double, 3>;

/// On a coil whose radius changes.
Point point_at(long k) {
  const double t = 0.05 * static_cast<double>(k);
  const double radius = 2 + std::cos(0.3 * t);
  return {radius * std::cos(t), radius * std::sin(t), 0.2 * t + std::sin(0.7 * t)};
}

/// A table of so many, with all of their digits.
std::string table(long count) {
  std::string text = "x,y,z\n";
  for (long k = 0; k < count; ++k) {
    const Point p = point_at(k);
    text += fmt::format("{:.17g},{:.17g},{:.17g}\n", p[0], p[1], p[2]);
  }
  return text;
}

/// θ at the end of the C² spline through range(0) points.
void points_angle(State& state) {
  const std::string text = table(state.range(0));
  for (auto _ : state) {
    const NamedPath named = read_any_path(text);
    benchmark::DoNotOptimize(answer(named, AngleQuery{}));
  }
  state.SetItemsProcessed(state.iterations() * state.range(0));
}

/// The numbers of the same.
void points_info(State& state) {
  const std::string text = table(state.range(0));
  for (auto _ : state) benchmark::DoNotOptimize(answer(read_any_path(text), InfoQuery{}));
  state.SetItemsProcessed(state.iterations() * state.range(0));
}

/// ∫ θ′ in doubles, by five points of Gauss's rule on each of range(0) cubics.
void points_angle_doubles(State& state) {
  constexpr std::array<double, 5> at{0.046910077030668, 0.230765344947158, 0.5, 0.769234655052842,
                                     0.953089922969332};
  constexpr std::array<double, 5> weight{0.118463442528095, 0.239314335249683, 0.284444444444444,
                                         0.239314335249683, 0.118463442528095};
  for (auto _ : state) {
    double angle = 0;
    for (long k = 0; k + 1 < state.range(0); ++k) {
      const Point a = point_at(k);
      const Point b = point_at(k + 1);
      const Point before = point_at(k - 1);
      const Point after = point_at(k + 2);
      for (std::size_t j = 0; j < at.size(); ++j) {
        const double t = at[j];
        Point h{};
        Point slope{};
        for (std::size_t i = 0; i < 3; ++i) {
          const double from = (b[i] - before[i]) / 2;
          const double to = (after[i] - a[i]) / 2;
          const double c = 3 * (b[i] - a[i]) - 2 * from - to;
          const double d = 2 * (a[i] - b[i]) + from + to;
          h[i] = from + t * (2 * c + 3 * t * d);
          slope[i] = 2 * c + 6 * t * d;
        }
        const double across = h[0] * h[0] + h[1] * h[1];
        const double size = std::sqrt(across + h[2] * h[2]);
        angle -= weight[j] * h[2] * (h[0] * slope[1] - h[1] * slope[0]) / (size * across);
      }
    }
    benchmark::DoNotOptimize(angle);
  }
  state.SetItemsProcessed(state.iterations() * state.range(0));
}

/// A PH spline of so many segments.
NamedPath ph_spline(long segments) {
  HermiteSpline data;
  for (long k = 0; k <= segments; ++k) {
    const auto exact = [](const Point& p) {
      return Vector<Rational>{exact_rational(p[0]), exact_rational(p[1]), exact_rational(p[2])};
    };
    data.points.push_back(exact(point_at(k)));
    const Vector<Rational> before = exact(point_at(k - 1));
    const Vector<Rational> after = exact(point_at(k + 1));
    data.derivatives.push_back(
        {(after[0] - before[0]) / 2, (after[1] - before[1]) / 2, (after[2] - before[2]) / 2});
    data.parameters.emplace_back(k);
  }
  const Rational tolerance = power_of_ten(-12);
  return {"", Path(quintic_spline(data, QuinticSelection::automatic, {tolerance, tolerance}).path)};
}

void ph_spline_info(State& state) {
  const NamedPath named = ph_spline(state.range(0));
  for (auto _ : state) benchmark::DoNotOptimize(answer(named, InfoQuery{}));
  state.SetItemsProcessed(state.iterations() * state.range(0));
}

void ph_spline_totals(State& state) {
  const NamedPath named = ph_spline(state.range(0));
  for (auto _ : state) benchmark::DoNotOptimize(answer(named, TotalsQuery{}));
  state.SetItemsProcessed(state.iterations() * state.range(0));
}

BENCHMARK(points_angle)->Arg(1000)->Arg(10'000)->Unit(benchmark::kMillisecond);
BENCHMARK(points_angle_doubles)->Arg(1000)->Arg(10'000)->Unit(benchmark::kMillisecond);
BENCHMARK(points_info)->Arg(1000)->Unit(benchmark::kMillisecond);
BENCHMARK(ph_spline_info)->Arg(100)->Arg(1000)->Unit(benchmark::kMillisecond);
BENCHMARK(ph_spline_totals)->Arg(100)->Arg(1000)->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace phrame::bench
