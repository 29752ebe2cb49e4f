// What kind of curve is it? The argument is m, the degree of the preimage.
#include <benchmark/benchmark.h>

#include "curves.hpp"
#include "phrame/ph/proof/classify.hpp"

namespace phrame::inline v0::bench {
namespace {

using State = benchmark::State;

/// All questions, witnesses checked.
void classify(State& state) {
  const Curve curve = random_curve(state.range(0));
  for (auto _ : state) benchmark::DoNotOptimize(phrame::classify(curve));
}

/// The most expensive one.
void rational_frame(State& state) {
  const Curve curve = random_curve(state.range(0));
  for (auto _ : state) benchmark::DoNotOptimize(phrame::rational_frame(curve.preimage()));
}

BENCHMARK(classify)->Arg(2)->Arg(5)->Arg(10)->Arg(20)->Arg(40)->Unit(benchmark::kMillisecond);
BENCHMARK(rational_frame)->Arg(2)->Arg(5)->Arg(10)->Arg(20)->Arg(40)->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace phrame::bench
