// Offsets of plane PH curves: exact, with their cusps, self-intersections and lengths.
#include "phrame/answer/offset.hpp"

#include <benchmark/benchmark.h>

#include "curves.hpp"
#include "phrame/answer/envelope.hpp"
#include "phrame/ph/offset/minkowski_spline.hpp"
#include "phrame/ph/offset/offset_measure.hpp"
#include "phrame/ph/offset/offset_meeting.hpp"

namespace phrame::inline v0::bench {
namespace {

using State = benchmark::State;

/// One whose offset has two cusps and meets itself three times.
Curve quintic() {
  return Curve({from_bernstein({-4, 6, -6}), {}, {}, from_bernstein({1, Rational(15, 14), -6})});
}
Rational distance() { return Rational(15557, 11760); }

void offset_quintic(State& state) {
  const Curve curve = quintic();
  const Rational d = distance();
  for (auto _ : state) benchmark::DoNotOptimize(offset(curve, d));
}

void offset_cusps(State& state) {
  const PhPath path(quintic());
  const Rational d = distance();
  for (auto _ : state) benchmark::DoNotOptimize(cusps(offset(path, d)).size());
}

/// All three are found, and that there are no others is proved.
void offset_self_intersections(State& state) {
  const PhPath path(quintic());
  const Rational d = distance();
  for (auto _ : state) {
    const SelfIntersections found = self_intersections(offset(path, d));
    if (found.found.size() != 3 || !found.is_complete()) state.SkipWithError("not the right ones");
    benchmark::DoNotOptimize(found.found.data());
  }
}

void offset_length(State& state) {
  const Offset made = offset(PhPath(quintic()), distance());
  for (auto _ : state) benchmark::DoNotOptimize(length(made).stretches.data());
}

/// All of it, as the program reports it.
void offset_report(State& state) {
  const NamedPath path("", PhPath(quintic()));
  for (auto _ : state)
    benchmark::DoNotOptimize(answer(path, OffsetQuery{{distance()}}).offsets.data());
}

/// Under an oval of degree 4: all of it from the factors on, of a curve of degree 13.
void offset_under_gauge(State& state) {
  const RationalCurve oval({Polynomial{4, 0, 0, 0, -4}, {0, 8, 0, 8}, {}}, {5, 0, 2, 0, 5});
  const Gauge gauge{Path(Segment(oval))};
  const Polynomial phi{-1, 2, Rational(1, 3)};
  const auto along = [&](const Polynomial& h) { return antiderivative(compose(h, phi)); };
  const Path path{
      Segment(RationalCurve({along(gauge.direction()[0]), along(gauge.direction()[1]), {}}))};
  for (auto _ : state) {
    const GaugeOffsets offsets(path, gauge);
    if (!offsets.none().empty()) state.SkipWithError("it is rational");
    benchmark::DoNotOptimize(cusps(offsets.at(Rational(1, 3))).size());
  }
}

/// A spline of a hundred curves with radii, to 10⁻¹⁵.
void minkowski_spline_100(State& state) {
  HermiteSpline data;
  for (long k = 0; k <= 100; ++k) {
    const Rational t(k, 10);
    data.points.push_back({t, t * t / 20, 1 + t / 5});
    data.derivatives.push_back({1, t / 10, Rational(1, 5)});
    data.parameters.push_back(t);
  }
  const Deviation tolerance{power_of_ten(-15), power_of_ten(-15)};
  for (auto _ : state) benchmark::DoNotOptimize(minkowski_spline(data, tolerance).axis.data());
}

/// A hundred bows, upwards and downwards in turn, of which the offset is cut on one side.
PhPath wave() {
  const Curve there({{1}, {}, {}, {-1, 2}}, Polynomial{4});
  PhPath path(there);
  for (long k = 1; k < 100; ++k) {
    const Vector<Rational> at = evaluate(position(path.segments().back()), 1);
    path.append(k % 2 == 0 ? Curve(there.preimage(), there.multiplier(), at)
                           : Curve({{1}, {}, {}, {1, -2}}, Polynomial{4}, at));
  }
  return path;
}

/// All branches of it, with cuts, lengths and areas.
void offset_trimmed_100(State& state) {
  const NamedPath path("", wave());
  OffsetQuery query{{Rational(3)}};
  query.trim = true;
  for (auto _ : state) benchmark::DoNotOptimize(answer(path, query).trimmed.data());
}

/// The same path with discs of one radius along it, cut on both sides.
void envelope_trimmed_100(State& state) {
  const PhPath path = wave();
  NamedAxis axis{"", {}};
  for (const Curve& curve : path.segments()) {
    Vector<Rational> start = curve.start();
    start[2] = 3;
    axis.segments.push_back(std::get<MinkowskiCurve>(identify_minkowski(hodograph(curve), start)));
  }
  for (auto _ : state) benchmark::DoNotOptimize(answer(axis, EnvelopeQuery{true}).branches.data());
}

BENCHMARK(envelope_trimmed_100)->Unit(benchmark::kMillisecond);
BENCHMARK(offset_trimmed_100)->Unit(benchmark::kMillisecond);
BENCHMARK(offset_quintic)->Unit(benchmark::kMicrosecond);
BENCHMARK(offset_cusps)->Unit(benchmark::kMicrosecond);
BENCHMARK(offset_self_intersections)->Unit(benchmark::kMillisecond);
BENCHMARK(offset_length)->Unit(benchmark::kMillisecond);
BENCHMARK(offset_under_gauge)->Unit(benchmark::kMillisecond);
BENCHMARK(minkowski_spline_100)->Unit(benchmark::kMillisecond);
BENCHMARK(offset_report)->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace phrame::bench
