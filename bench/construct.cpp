// Exact C1 and C2 splines of PH curves through points. The first argument is the number of
// segments, the second −log10 of the tolerance; the time is that of all segments.
#include <benchmark/benchmark.h>

#include <random>

#include "phrame/algebra/rounding.hpp"
#include "phrame/ph/construct/c2_hermite.hpp"
#include "phrame/ph/construct/c2_spline.hpp"
#include "phrame/ph/construct/helical_spline.hpp"
#include "phrame/ph/construct/quintic_family.hpp"
#include "phrame/ph/construct/quintic_spline.hpp"
#include "phrame/ph/construct/rmf_spline.hpp"
#include "phrame/ph/construct/rrmf_spline.hpp"

namespace phrame::inline v0::bench {
namespace {

using State = benchmark::State;

/// Points and derivatives with 6 decimals, parameters at steps of about 1.
HermiteSpline spline_data(long segments) {
  std::mt19937_64 engine(7);
  const auto decimal = [&](long low, long high) {
    return Rational(std::uniform_int_distribution<long>(low, high)(engine), 1'000'000);
  };
  HermiteSpline data;
  for (long k = 0; k <= segments; ++k) {
    const auto coordinate = [&] { return decimal(-1'000'000, 1'000'000); };
    data.points.push_back({k + coordinate(), coordinate(), coordinate()});
    data.derivatives.push_back({1 + coordinate(), coordinate(), coordinate()});
    data.parameters.push_back(k == 0 ? Rational(0)
                                     : data.parameters.back() + decimal(500'000, 1'500'000));
  }
  return data;
}

void construct_quintics(State& state) {
  const HermiteSpline data = spline_data(state.range(0));
  const Rational tolerance = power_of_ten(-state.range(1));
  for (auto _ : state)
    benchmark::DoNotOptimize(
        quintic_spline(data, QuinticSelection::automatic, {tolerance, tolerance}));
  state.SetItemsProcessed(state.iterations() * state.range(0));
}
BENCHMARK(construct_quintics)->Args({1, 15})->Args({100, 15})->Args({1000, 15})->Args({1000, 40});

void construct_helices(State& state) {
  const HermiteSpline data = spline_data(state.range(0));
  const Rational tolerance = power_of_ten(-state.range(1));
  for (auto _ : state) benchmark::DoNotOptimize(helical_spline(data, 1, {tolerance, tolerance}));
  state.SetItemsProcessed(state.iterations() * state.range(0));
}
BENCHMARK(construct_helices)->Args({1, 15})->Args({100, 15})->Args({100, 40});

/// Of points and tangents of (t, t² + t³/5, t³/3) for 0 ≤ t ≤ 2.
void construct_rrmf_quintics(State& state) {
  HermiteSpline data;
  for (long k = 0; k <= state.range(0); ++k) {
    const Rational t(2 * k, state.range(0));
    data.points.push_back({t, t * t + t * t * t / 5, t * t * t / 3});
    data.derivatives.push_back({1, 2 * t + 3 * t * t / 5, t * t});
    data.parameters.emplace_back(k);
  }
  const Rational tolerance = power_of_ten(-15);
  for (auto _ : state) benchmark::DoNotOptimize(rrmf_spline(data, {tolerance, tolerance}));
  state.SetItemsProcessed(state.iterations() * state.range(0));
}
BENCHMARK(construct_rrmf_quintics)->Arg(1)->Arg(8)->Arg(32);

void construct_rmf_septics(State& state) {
  const HermiteSpline data = spline_data(state.range(0));
  const Rational tolerance = power_of_ten(-state.range(1));
  for (auto _ : state) benchmark::DoNotOptimize(rmf_spline(data, {tolerance, tolerance}));
  state.SetItemsProcessed(state.iterations() * state.range(0));
}
BENCHMARK(construct_rmf_septics)->Args({1, 15})->Args({100, 15})->Args({1000, 15})->Args({100, 40});

/// The choice of one quintic, in doubles.
void choose_quintic(State& state) {
  const QuinticFamily family({{1, 1, 1}, {-0.8, 0.3, 1.2}, {0.5, -1.3, -1}});
  for (auto _ : state)
    benchmark::DoNotOptimize(family.choose(static_cast<QuinticSelection>(state.range(0))));
}
BENCHMARK(choose_quintic)
    ->Arg(static_cast<long>(QuinticSelection::automatic))
    ->Arg(static_cast<long>(QuinticSelection::bv))
    ->Arg(static_cast<long>(QuinticSelection::energy));

void close_spline(State& state) {
  HermiteSpline data = spline_data(4);
  data.points.back() = data.points.front();
  data.derivatives.back() = data.derivatives.front();
  data.is_closed = true;
  const Rational tolerance = power_of_ten(-state.range(0));
  for (auto _ : state)
    benchmark::DoNotOptimize(
        quintic_spline(data, QuinticSelection::automatic, {tolerance, tolerance}));
}
BENCHMARK(close_spline)->Arg(15)->Arg(40);

void meet_points(State& state) {
  const HermiteSpline data = spline_data(state.range(0));
  const Rational tolerance = power_of_ten(-state.range(1));
  for (auto _ : state)
    benchmark::DoNotOptimize(quintic_spline(data, QuinticSelection::automatic,
                                            {tolerance, tolerance}, PointRule::exact));
  state.SetItemsProcessed(state.iterations() * state.range(0));
}
BENCHMARK(meet_points)->Args({100, 15})->Args({100, 40});

/// Through points only, with chord lengths.
HermiteSpline points_data(long segments, bool is_closed) {
  GivenPoints given;
  given.points = spline_data(segments).points;
  return hermite_spline(given, is_closed);
}

void construct_c2(State& state) {
  const HermiteSpline data = points_data(state.range(0), false);
  const Rational tolerance = power_of_ten(-state.range(1));
  for (auto _ : state) benchmark::DoNotOptimize(c2_spline(data, {tolerance, tolerance}));
  state.SetItemsProcessed(state.iterations() * state.range(0));
}
BENCHMARK(construct_c2)->Args({100, 15})->Args({1000, 12})->Args({1000, 40});

void close_c2(State& state) {
  const HermiteSpline data = points_data(state.range(0), true);
  const Rational tolerance = power_of_ten(-15);
  for (auto _ : state) benchmark::DoNotOptimize(c2_spline(data, {tolerance, tolerance}));
  state.SetItemsProcessed(state.iterations() * state.range(0));
}
BENCHMARK(close_c2)->Arg(10)->Arg(100)->Arg(1000);

void construct_c2_hermite(State& state) {
  HermiteSpline data = spline_data(state.range(0));
  data.accelerations = data.derivatives;
  const Rational tolerance = power_of_ten(-state.range(1));
  for (auto _ : state)
    benchmark::DoNotOptimize(c2_hermite_spline(data, {tolerance, tolerance, tolerance}));
  state.SetItemsProcessed(state.iterations() * state.range(0));
}
BENCHMARK(construct_c2_hermite)->Args({100, 15})->Args({1000, 15})->Args({1000, 40});

}  // namespace
}  // namespace phrame::bench
