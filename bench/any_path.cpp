// Curves that need not be Pythagorean: an angle to so many digits, all found anew, and tables of
// frames, certified and compiled.
#include <benchmark/benchmark.h>

#include "curves.hpp"
#include "phrame/algebra/rounding.hpp"
#include "phrame/io/read/formula.hpp"
#include "phrame/ph/along/path_length.hpp"
#include "phrame/ph/frame/compiled_angle.hpp"
#include "phrame/ph/frame/compiled_frame.hpp"
#include "phrame/ph/frame/path_frame.hpp"
#include "phrame/ph/twist/minimal_twist.hpp"

namespace phrame::inline v0::bench {
namespace {

using State = benchmark::State;

/// Of degree range(0), to range(1) digits.
void any_path_angle(State& state) {
  const Path path = bezier_path(state.range(0));
  for (auto _ : state) {
    const PathAngle angle(path);
    benchmark::DoNotOptimize(round_to_decimal(angle.value({0, Rational(1)}), state.range(1)));
  }
}

/// (2 + cos 3s)(cos 2s, sin 2s), sin 3s.
Path trefoil() {
  const auto f = [](const char* text) { return parse_formula(text, "s").value; };
  return Path(
      ExpressionCurve({f("(2 + cos(3*s))*cos(2*s)"), f("(2 + cos(3*s))*sin(2*s)"), f("sin(3*s)")},
                      f("0"), f("2*pi")));
}

/// Of degree range(0), or by formulas for 0.
Path path_of(const State& state) {
  return state.range(0) == 0 ? trefoil() : bezier_path(state.range(0));
}

/// 1001 rotation-minimizing frames in doubles.
void any_path_frames(State& state) {
  for (auto _ : state) {
    const Path path = path_of(state);  // which keeps what is found of integrals
    const PathAngle angle(path);
    for (long k = 0; k <= 1000; ++k) {
      const auto frame = rotation_minimizing_frame(angle, {0, Rational(k, 1000)});
      benchmark::DoNotOptimize(round_to_double(frame.e2));
      benchmark::DoNotOptimize(round_to_double(frame.e3));
    }
  }
}

/// 241 frames of the closing minimal twist of the trefoil, in whose middle some components are 0.
void any_path_twist_frames(State& state) {
  for (auto _ : state) {
    const Path path = trefoil();
    const PathAngle angle(path);
    const MinimalTwist twist = minimal_twist(angle, Angle(), Angle());
    for (long k = 0; k <= 240; ++k) {
      const auto frame = minimal_twist_frame(twist, {0, Rational(k, 240)});
      benchmark::DoNotOptimize(round_to_double(frame.e2));
      benchmark::DoNotOptimize(round_to_double(frame.e3));
    }
  }
}

/// The proved polynomials of the frame.
void any_path_compile(State& state) {
  for (auto _ : state) benchmark::DoNotOptimize(CompiledFrames(PathAngle(path_of(state))));
}

/// One frame by these, at scattered t.
void any_path_compiled_frame(State& state) {
  const CompiledFrames frames = CompiledFrames(PathAngle(path_of(state)));
  double t = 0;
  for (auto _ : state) {
    t += 0.6180339887498949;
    if (t >= 1) t -= 1;
    benchmark::DoNotOptimize(frames(t));
  }
}

/// ∫ |r′| dt, to 50 digits.
void any_path_length(State& state) {
  const Path path = bezier_path(state.range(0));
  for (auto _ : state) benchmark::DoNotOptimize(round_to_decimal(PathLength(path).total(), 50));
}

}  // namespace

BENCHMARK(any_path_angle)
    ->ArgsProduct({{3, 9}, {17, 50}})
    ->ArgNames({"degree", "digits"})
    ->Unit(benchmark::kMillisecond);
BENCHMARK(any_path_frames)->Arg(3)->Arg(9)->Arg(0)->Unit(benchmark::kMillisecond);
BENCHMARK(any_path_twist_frames)->Unit(benchmark::kMillisecond);
BENCHMARK(any_path_compile)->Arg(3)->Arg(9)->Arg(0)->Unit(benchmark::kMillisecond);
BENCHMARK(any_path_compiled_frame)->Arg(3)->Arg(0);
BENCHMARK(any_path_length)->Arg(3)->Arg(9)->Unit(benchmark::kMillisecond);

}  // namespace phrame::bench
