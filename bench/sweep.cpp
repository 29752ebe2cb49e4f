// Bodies swept along curves: 10⁴ sections, tolerances, exact surfaces, files. Items are sections or
// patches.
#include "phrame/answer/sweep.hpp"

#include <benchmark/benchmark.h>

#include "curves.hpp"
#include "phrame/answer/rational_sweep.hpp"
#include "phrame/io/write/mesh.hpp"

namespace phrame::inline v0::bench {
namespace {

using State = benchmark::State;

constexpr long sections = 10'000;

NamedPhPath quintic() { return {"", PhPath(random_curve(2))}; }

/// The trefoil knot of examples/any.
NamedPath trefoil() {
  const Formula s = Formula::variable();
  return {"", Segment(ExpressionCurve(
                  {(Formula(2) + cos(Formula(3) * s)) * cos(Formula(2) * s),
                   (Formula(2) + cos(Formula(3) * s)) * sin(Formula(2) * s), sin(Formula(3) * s)},
                  Formula(0), Formula(0, 2)))};
}

SweepQuery of_sections() {
  SweepQuery query{regular_polygon(16, Rational(1, 10))};
  query.tolerance_or_sections = sections;
  return query;
}

template <class Named>
void run_sweep(State& state, const Named& path, const SweepQuery& query) {
  std::size_t count = 0;
  for (auto _ : state) {
    const SweepAnswer made = answer(path, query);
    count += made.body.sections;
    benchmark::DoNotOptimize(made.body.mesh.triangles.data());
  }
  state.SetItemsProcessed(static_cast<long>(count));
}

/// All of it: the frame's pieces, proved, and the mesh, checked.
void sweep_sections(State& state) { run_sweep(state, quintic(), of_sections()); }
void sweep_sections_any_curve(State& state) { run_sweep(state, trefoil(), of_sections()); }

/// A turn needs the length up to each section.
void sweep_sections_twisted(State& state) {
  SweepQuery query = of_sections();
  query.twist = Angle(2, 0);
  query.scale = RationalFunction(Polynomial{2, -1});
  run_sweep(state, quintic(), query);
}

/// Within 10^−k, the argument.
void sweep_within(State& state) {
  const Rational tolerance = power_of_ten(-state.range(0));
  SweepQuery query{circle_profile(1, tolerance / 4)};
  query.tolerance_or_sections = tolerance;
  run_sweep(state, quintic(), query);
}

/// Normals within 1°, of a profile that turns.
void sweep_within_normals(State& state) {
  SweepQuery query{rectangle_profile(1, Rational(1, 2))};
  query.tolerance_or_sections = Rational(1, 100);
  query.normal_tolerance = Angle(Rational(1, 180), 0);
  query.twist = Angle(1, 0);
  run_sweep(state, quintic(), query);
}

/// A plane profile with so many holes, whose caps are triangulated.
void sweep_caps_with_holes(State& state) {
  const long side = state.range(0);
  std::vector<std::vector<ProfilePoint>> rings{rectangle_profile(10, 10).corners()};
  for (long x = 0; x < side; ++x)
    for (long y = 0; y < side; ++y) {
      auto hole = regular_polygon(12, Rational(2, side)).corners();
      for (auto& corner : hole) {
        corner[0] += Rational(10 * x + 5, side) - 5;
        corner[1] += Rational(10 * y + 5, side) - 5;
      }
      rings.push_back(hole);
    }
  SweepQuery query{Profile::of_rings(rings)};
  query.tolerance_or_sections = 2L;
  run_sweep(state, NamedPhPath{"", PhPath(Curve({{1}, {}, {}, {}}))}, query);
}

/// In a rational frame of minimal twist.
void sweep_exact(State& state) {
  RationalSweepQuery query{circle_curve(Rational(1, 10))};
  query.twist_degree = 2;
  query.end_normal = Vector<Rational>{1, 2, 3};
  const NamedPhPath path = quintic();
  std::size_t patches = 0;
  for (auto _ : state) patches += answer(path, query).surface.patches.size();
  state.SetItemsProcessed(static_cast<long>(patches));
}

/// Of 10⁴ sections, 320 000 triangles.
template <class Write>
void run_write(State& state, Write write) {
  const SweepAnswer made = answer(quintic(), of_sections());
  std::size_t bytes = 0;
  for (auto _ : state) bytes += write(made.body.mesh).size();
  state.SetBytesProcessed(static_cast<long>(bytes));
}
void sweep_write_obj(State& state) {
  run_write(state, [](const Mesh& mesh) { return to_obj(mesh); });
}
void sweep_write_glb(State& state) {
  run_write(state, [](const Mesh& mesh) { return to_glb(mesh); });
}

BENCHMARK(sweep_sections)->Unit(benchmark::kMillisecond);
BENCHMARK(sweep_sections_any_curve)->Unit(benchmark::kMillisecond);
BENCHMARK(sweep_sections_twisted)->Unit(benchmark::kMillisecond);
BENCHMARK(sweep_within)->Arg(3)->Arg(5)->Unit(benchmark::kMillisecond);
BENCHMARK(sweep_within_normals)->Unit(benchmark::kMillisecond);
BENCHMARK(sweep_caps_with_holes)->Arg(8)->Arg(32)->Unit(benchmark::kMillisecond);
BENCHMARK(sweep_exact)->Unit(benchmark::kMillisecond);
BENCHMARK(sweep_write_obj)->Unit(benchmark::kMillisecond);
BENCHMARK(sweep_write_glb)->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace phrame::bench
