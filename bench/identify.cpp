// Is a curve PH, and what is its preimage? The argument is m, the degree of the preimage; r′ has
// degree 2m.
#include <benchmark/benchmark.h>

#include "curves.hpp"

namespace phrame::inline v0::bench {
namespace {

using State = benchmark::State;

/// From r′, known to be PH.
void identify(State& state) {
  const Vector<Polynomial> r1 = hodograph(random_curve(state.range(0)));
  for (auto _ : state) benchmark::DoNotOptimize(phrame::identify(r1));
}

/// The same with all coefficients of r′ multiplied by f = (t + 1/3)², and turned, so that they are
/// long.
void identify_turned(State& state) {
  const Curve curve = rotated(random_curve(state.range(0)), {1234567, 7654321, 2468013, 1357911});
  const Curve given(curve.preimage(), {Rational(1, 9), Rational(2, 3), 1});
  const Vector<Polynomial> r1 = hodograph(given);
  for (auto _ : state) benchmark::DoNotOptimize(phrame::identify(r1));
}

/// One control point is off by 10⁻³⁰.
void identify_refused(State& state) {
  auto points = control_points(random_curve(state.range(0)));
  points[1][0] += parse_rational("1e-30");
  const Vector<Polynomial> r1 = bezier_hodograph(points);
  for (auto _ : state) benchmark::DoNotOptimize(phrame::identify(r1));
}

/// The PH curve near control points in doubles.
void near(State& state) {
  auto points = control_points(random_curve(state.range(0)));
  for (auto& p : points)
    for (Rational& x : p) x = exact_rational(static_cast<double>(x));
  const Vector<Polynomial> r1 = bezier_hodograph(points);
  for (auto _ : state)
    benchmark::DoNotOptimize(phrame::near_curve(r1, points.front(), parse_rational("1e-9")));
}

void all_m(benchmark::internal::Benchmark* b) {
  for (const long m : {2, 5, 10, 20, 40}) b->Arg(m);
}
BENCHMARK(identify)->Apply(all_m);
BENCHMARK(identify_turned)->Apply(all_m);
BENCHMARK(identify_refused)->Apply(all_m);
BENCHMARK(near)->Arg(2)->Arg(5)->Arg(10)->Arg(20);

}  // namespace
}  // namespace phrame::bench
