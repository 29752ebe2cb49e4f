// The angle at t = 1 to 40 digits with a certificate, and the check of it. The argument is m, the
// degree of the preimage.
#include "phrame/ph/proof/certify.hpp"

#include <benchmark/benchmark.h>

#include "curves.hpp"
#include "phrame/integrate/quadrature.hpp"
#include "phrame/ph/proof/verify.hpp"

namespace phrame::inline v0::bench {
namespace {

using State = benchmark::State;

void certify(State& state) {
  const Curve curve = random_curve(state.range(0));
  for (auto _ : state)
    benchmark::DoNotOptimize(phrame::certify(curve, Reference::euler_rodrigues, {1}, 40));
}

void verify(State& state) {
  const Certificate certificate =
      phrame::certify(random_curve(state.range(0)), Reference::euler_rodrigues, {1}, 40);
  for (auto _ : state) benchmark::DoNotOptimize(phrame::verify(certificate));
}

/// The angle by numerical integration, to 50 digits.
void quadrature(State& state) {
  const RationalFunction rate = rate_to_erf(random_curve(state.range(0)).preimage());
  for (auto _ : state) benchmark::DoNotOptimize(phrame::quadrature(rate, 0, 1, 170));
}

BENCHMARK(certify)->Arg(2)->Arg(5)->Arg(10)->Arg(20)->Arg(40)->Unit(benchmark::kMillisecond);
BENCHMARK(verify)->Arg(2)->Arg(5)->Arg(10)->Arg(20)->Arg(40)->Unit(benchmark::kMillisecond);
BENCHMARK(quadrature)->Arg(2)->Arg(5)->Arg(10)->Arg(20)->Arg(40)->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace phrame::bench
