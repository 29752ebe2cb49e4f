// What a curve or spline gathers from start to end, each value to 17 digits.
#include "phrame/ph/along/totals.hpp"

#include <benchmark/benchmark.h>

#include "curves.hpp"
#include "phrame/ph/along/path_angle.hpp"
#include "phrame/ph/curve/transform.hpp"

namespace phrame::inline v0::bench {
namespace {

using State = benchmark::State;

/// ∫ κ² ds: σ³ has repeated roots.
void bending_energy(State& state) {
  const Curve curve = random_curve(state.range(0));
  for (auto _ : state) {
    const auto energy = phrame::bending_energy(curve);
    benchmark::DoNotOptimize(round_to_decimal(std::get<CurveTotal>(energy).value, 17));
  }
}

/// ∫ (κ² + τ²) ds, of degree 14m − 8: the largest.
void frenet_energy(State& state) {
  const Curve curve = random_curve(state.range(0));
  for (auto _ : state) {
    const auto energy = phrame::frenet_energy(curve);
    benchmark::DoNotOptimize(round_to_decimal(std::get<CurveTotal>(energy).value, 17));
  }
}

/// ∫ τ ds: the argument of the bend beside the twist.
void total_torsion(State& state) {
  const Curve curve = random_curve(state.range(0));
  for (auto _ : state) {
    const CurveTotal torsion = phrame::total_torsion(curve);
    benchmark::DoNotOptimize(round_to_decimal(torsion.value, 17));
  }
}

/// θ at the end of a quintic in so many pieces, the joints checked.
void spline_angle(State& state) {
  const Curve curve = random_curve(2);
  const long n = state.range(0);
  std::vector<Curve> pieces;
  for (long k = 0; k < n; ++k) pieces.push_back(segment(curve, Rational(k, n), Rational(k + 1, n)));
  for (auto _ : state) {
    PhPath path(pieces.front());
    for (std::size_t k = 1; k < pieces.size(); ++k) path.append(pieces[k]);
    PathAngle angle(path);
    benchmark::DoNotOptimize(round_to_decimal(angle.value(n), 17));
  }
}

BENCHMARK(bending_energy)->Arg(2)->Arg(5)->Arg(10)->Arg(20)->Unit(benchmark::kMillisecond);
BENCHMARK(frenet_energy)->Arg(2)->Arg(5)->Arg(10)->Arg(20)->Arg(80)->Unit(benchmark::kMillisecond);
BENCHMARK(total_torsion)->Arg(2)->Arg(20)->Arg(80)->Unit(benchmark::kMillisecond);
BENCHMARK(spline_angle)->Arg(10)->Arg(100)->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace phrame::bench
