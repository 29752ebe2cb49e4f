// Points along a curve: equal arc lengths, equal times. The medians are times a point.
#include <benchmark/benchmark.h>

#include "curves.hpp"

namespace phrame::inline v0::bench {
namespace {

using State = benchmark::State;

/// The k-th of 1000 equal steps to `end`.
Rational step(const Rational& end, long k) { return end * Rational(k % 1001, 1000); }

/// t at an arc length, correctly rounded to double.
void inverse_arc_length(State& state) {
  const ArcLength length(random_curve(state.range(0)));
  long k = 0;
  for (auto _ : state)
    benchmark::DoNotOptimize(round_to_double(length.parameter(step(length.total(), ++k))));
  state.SetItemsProcessed(state.iterations());
}

/// The same as an algebraic number, with its irreducible polynomial.
void algebraic_parameter(State& state) {
  const ArcLength length(random_curve(state.range(0)));
  long k = 0;
  for (auto _ : state)
    benchmark::DoNotOptimize(length.algebraic_parameter(step(length.total(), ++k)));
  state.SetItemsProcessed(state.iterations());
}

/// A row of `phrame frames --by arc-length`: 13 numbers.
void frame_by_arc_length(State& state) {
  const Curve curve = random_curve(state.range(0));
  const ArcLength length(curve);
  std::vector<RealAlgebraic> at;
  for (long k = 1; k <= 20; ++k)
    at.push_back(length.algebraic_parameter(step(length.total(), 49 * k)));
  for (auto _ : state)
    benchmark::DoNotOptimize(frame_table(curve, TableColumns{{TabulatedFrame::rmf}}, at));
  state.SetItemsProcessed(state.iterations() * 20);
}

/// A table of `phrame interpolate` with 100 points; V = 1 + cs brings logarithms, V = 1 none.
void interpolate(State& state, const Polynomial& speed) {
  const Curve curve = random_curve(state.range(0));
  const Feedrate feedrate{RationalFunction(speed)};
  const Real total = TravelTime(Path(PhSegment(curve)), feedrate).total();
  const InterpolationQuery query{feedrate, Rational(total.enclose(64).upper()) / 100};
  for (auto _ : state) benchmark::DoNotOptimize(answer(NamedPhPath("", curve), query));
  state.SetItemsProcessed(state.iterations() * 100);
}
void interpolate_constant(State& state) { interpolate(state, {1}); }
void interpolate_linear(State& state) { interpolate(state, {1, Rational(1, 10)}); }

BENCHMARK(inverse_arc_length)->Arg(2)->Arg(10)->Arg(20);
BENCHMARK(algebraic_parameter)->Arg(2)->Arg(10)->Arg(20);
BENCHMARK(frame_by_arc_length)->Arg(2)->Arg(10);
BENCHMARK(interpolate_constant)->Arg(2)->Arg(10);
BENCHMARK(interpolate_linear)->Arg(2)->Arg(10);

}  // namespace
}  // namespace phrame::bench
