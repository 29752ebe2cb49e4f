// Frames of minimal twist of a quintic, the first example of Farouki and Moon, and of random
// curves; the argument is m, the degree of the preimage.
#include <benchmark/benchmark.h>

#include "curves.hpp"
#include "phrame/ph/twist/twist_frame.hpp"
#include "phrame/ph/twist/wronskian_frame.hpp"

namespace phrame::inline v0::bench {
namespace {

using State = benchmark::State;

Curve example() {
  const auto decimals = [](std::initializer_list<const char*> texts) {
    std::vector<Rational> values;
    for (const char* text : texts) values.push_back(parse_rational(text));
    return from_bernstein(values);
  };
  return Curve({decimals({"-0.9515", "-0.2085", "1.2294"}),
                decimals({"0.9515", "1.4435", "0.6264"}), decimals({"0.3941", "-0.2981", "1.3768"}),
                decimals({"-0.3941", "1.0472", "-0.0915"})});
}

/// From the curve to a rational frame with a quadratic w, proved to `bits` bits where > 0.
void build(State& state, const Curve& curve, long bits) {
  for (auto _ : state) {
    PathAngle angle{PhPath(curve)};
    const MinimalTwist mtf(angle, FrameAngle{}, FrameAngle{Rational(-5, 8), 0});
    const TwistPiece piece = twist_pieces(mtf, {}).front();
    const BestTwist best = best_twist(piece, {2, EndRates::matched, bits > 0, bits});
    if (bits > 0 && !best.minimum) state.SkipWithError("not proved");
    benchmark::DoNotOptimize(best);
  }
}

void exact_twist_frame(State& state) {
  const Curve curve = example();
  for (auto _ : state) {
    PathAngle angle{PhPath(curve)};
    const MinimalTwist mtf(angle, FrameAngle{}, FrameAngle{Rational(-5, 8), 0});
    benchmark::DoNotOptimize(mtf.value(Rational(1, 2)).enclose(64));
  }
}

void rational_twist_frame(State& state) { build(state, example(), 0); }
void rational_twist_frame_proved_12(State& state) { build(state, example(), 44); }
void rational_twist_frame_proved_20(State& state) { build(state, example(), 72); }

void rational_twist_frame_of_degree(State& state) { build(state, random_curve(state.range(0)), 0); }

/// A quintic in so many pieces, each proved.
void rational_twist_frame_in_pieces(State& state) {
  const Curve curve = random_curve(2);
  const long n = state.range(0);
  std::vector<Rational> points;
  for (long k = 1; k < n; ++k) points.emplace_back(k, n);
  for (auto _ : state) {
    PathAngle angle{PhPath(curve)};
    const MinimalTwist mtf(angle, FrameAngle{}, FrameAngle{0, 1});
    const TwistFrame frame = twist_frame(mtf, {}, {points});
    benchmark::DoNotOptimize(root_mean_square(frame).enclose(64));
  }
}

/// The best pair of polynomials with ab′ − a′b = 2hσ, proved; the argument is its FrameWeight.
void wronskian_frame(State& state) {
  const Curve curve = example();
  for (auto _ : state) {
    const WronskianFrame frame(curve, static_cast<FrameWeight>(state.range(0)));
    benchmark::DoNotOptimize(frame.rounded(72));
  }
}

BENCHMARK(wronskian_frame)->DenseRange(0, 2)->Unit(benchmark::kMillisecond);
BENCHMARK(exact_twist_frame)->Unit(benchmark::kMillisecond);
BENCHMARK(rational_twist_frame)->Unit(benchmark::kMillisecond);
BENCHMARK(rational_twist_frame_proved_12)->Unit(benchmark::kMillisecond);
BENCHMARK(rational_twist_frame_proved_20)->Unit(benchmark::kMillisecond);
BENCHMARK(rational_twist_frame_in_pieces)->Arg(10)->Arg(100)->Unit(benchmark::kMillisecond);
BENCHMARK(rational_twist_frame_of_degree)
    ->Arg(2)
    ->Arg(5)
    ->Arg(10)
    ->Arg(20)
    ->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace phrame::bench
