// Many values of one curve: compiled angles and frames, a compiled header, and beside them, at the
// same parameters, what is done elsewhere in doubles, with the errors of all.
#include <benchmark/benchmark.h>

#include <algorithm>
#include <cmath>
#include <random>

#include "curves.hpp"
#include "phrame/io/write/c_header.hpp"
#include "phrame/ph/along/path_angle.hpp"
#include "phrame/ph/curve/transform.hpp"
#include "quintic.h"  // by phrame compile

namespace phrame::inline v0::bench {
namespace {

using State = benchmark::State;
using Point = Vector<double>;

std::vector<double> random_parameters() {
  std::mt19937_64 engine(1);
  std::uniform_real_distribution<double> uniform(0, 1);
  std::vector<double> at(4096);
  for (double& t : at) t = uniform(engine);
  return at;
}

/// f(t, values) for so many t at once, random ones, and ascending where range(1) is 1; per value.
template <class Value, class F>
void arrays(State& state, F f) {
  std::vector<double> at = random_parameters();
  if (state.range(1) == 1) std::sort(at.begin(), at.end());
  std::vector<Value> found(at.size());
  for (auto _ : state) {
    f(at, found);
    benchmark::ClobberMemory();
  }
  state.SetItemsProcessed(state.iterations() * static_cast<long>(at.size()));
}

/// f(t) for random t.
template <class F>
void values(State& state, F f) {
  const auto at = random_parameters();
  std::size_t k = 0;
  for (auto _ : state) benchmark::DoNotOptimize(f(at[++k % at.size()]));
  state.SetItemsProcessed(state.iterations());
}

void compile_angle(State& state) {
  const Curve curve = random_curve(state.range(0));
  RmfAngle angle(curve, Reference::euler_rodrigues);
  for (auto _ : state) benchmark::DoNotOptimize(CompiledAngle(angle, 0, 1));
}
void compile_frames(State& state) {
  const Curve curve = random_curve(state.range(0));
  RmfAngle angle(curve, Reference::euler_rodrigues);
  for (auto _ : state) benchmark::DoNotOptimize(CompiledFrames(curve, angle, 0, 1));
}

/// A spline of so many segments, those of a quintic, as phrame compile does it: the joints checked,
/// the angle and the rotation approximated, the header written. In proportion to their number.
void compile_spline(State& state) {
  const Curve curve = random_curve(2);
  const long n = state.range(0);
  std::vector<Curve> segments;
  for (long k = 0; k < n; ++k)
    segments.push_back(segment(curve, Rational(k, n), Rational(k + 1, n)));
  for (auto _ : state) {
    PhPath path(segments.front());
    for (std::size_t k = 1; k < segments.size(); ++k) path.append(segments[k]);
    benchmark::DoNotOptimize(to_c_header(answer({"", path}, CompiledQuery{}), "spline"));
  }
  state.SetComplexityN(n);
}

/// Correctly rounded.
void compiled_angle(State& state) {
  RmfAngle angle(random_curve(state.range(0)), Reference::euler_rodrigues);
  CompiledAngle compiled(angle, 0, 1);
  values(state, [&](double t) { return compiled(t); });
}
/// Every component within 2^−53.
void compiled_frame(State& state) {
  const Curve curve = random_curve(state.range(0));
  RmfAngle angle(curve, Reference::euler_rodrigues);
  const CompiledFrames compiled(curve, angle, 0, 1);
  values(state, [&](double t) { return compiled(t); });
}

void compiled_angle_array(State& state) {
  RmfAngle angle(random_curve(state.range(0)), Reference::euler_rodrigues);
  CompiledAngle compiled(angle, 0, 1);
  arrays<double>(state, compiled);
}
/// Every component within 2^−53, and correctly rounded but for some in a million.
void compiled_frame_array(State& state) {
  const Curve curve = random_curve(state.range(0));
  RmfAngle angle(curve, Reference::euler_rodrigues);
  arrays<Frame<double>>(state, CompiledFrames(curve, angle, 0, 1));
}

/// Of the quintic, whatever range(0).
void header_angle_array(State& state) {
  arrays<double>(state, [](const std::vector<double>& t, std::vector<double>& theta) {
    quintic_theta_array(t.data(), theta.data(), t.size());
  });
}
void header_frame_array(State& state) {
  arrays<Frame<double>>(state,
                        [](const std::vector<double>& t, std::vector<Frame<double>>& frames) {
                          quintic_frame_array(t.data(), frames.front().e1.data(), t.size());
                        });
}

void header_angle(State& state) { values(state, quintic_theta); }
void header_frame(State& state) {
  values(state, [](double t) {
    Frame<double> frame;
    quintic_frame(t, frame.e1.data(), frame.e2.data(), frame.e3.data());
    return frame;
  });
}

// ---- N steps from t = 0 to 1 along the quintic of [Farouki 2003]

double horner(const std::vector<double>& c, double t) {
  double s = 0;
  for (auto it = c.rbegin(); it != c.rend(); ++it) s = s * t + *it;
  return s;
}

std::vector<double> doubles(const Polynomial& p) {
  std::vector<double> c;
  for (const Rational& x : p.coefficients()) c.push_back(round_to_double(x));
  return c;
}

struct DoubleCurve {
  std::array<std::vector<double>, 3> position;
  std::array<std::vector<double>, 3> hodograph;

  explicit DoubleCurve(const Curve& curve) {
    for (std::size_t k = 0; k < 3; ++k) {
      position[k] = doubles(phrame::position(curve)[k]);
      hodograph[k] = doubles(phrame::hodograph(curve)[k]);
    }
  }
};

Curve quintic() {
  return Curve({from_bernstein({2, 0, 2}), from_bernstein({1, 1, 0}), from_bernstein({0, -2, 0}),
                from_bernstein({1, 2, 1})});
}

double dot(const Point& a, const Point& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }
Point less(const Point& a, double c, const Point& b) {
  return {a[0] - c * b[0], a[1] - c * b[1], a[2] - c * b[2]};
}
Point mirrored(const Point& a, const Point& v, double square) {
  return less(a, 2 * dot(v, a) / square, v);
}

/// Double reflection: f₂ after each step [Wang, Jüttler, Zheng, Liu 2008].
void double_reflection(const DoubleCurve& curve, Point f2, long steps, std::vector<Point>& out) {
  Point at{};
  Point tangent{};
  for (long k = 0; k <= steps; ++k) {
    const double t = static_cast<double>(k) / static_cast<double>(steps);
    Point next, next_tangent;
    for (std::size_t i = 0; i < 3; ++i) {
      next[i] = horner(curve.position[i], t);
      next_tangent[i] = horner(curve.hodograph[i], t);
    }
    const double length = std::sqrt(dot(next_tangent, next_tangent));
    for (double& x : next_tangent) x /= length;
    if (k > 0) {
      const Point v1 = less(next, 1, at);
      const double c1 = dot(v1, v1);
      const Point v2 = less(next_tangent, 1, mirrored(tangent, v1, c1));
      f2 = mirrored(mirrored(f2, v1, c1), v2, dot(v2, v2));
    }
    at = next;
    tangent = next_tangent;
    out[static_cast<std::size_t>(k)] = f2;
  }
}

/// θ after each step by three-point Gauss quadrature of −2h/σ.
void gauss(const std::vector<double>& n, const std::vector<double>& d, long steps,
           std::vector<double>& out) {
  const double offset = std::sqrt(0.15);  // √(3/5)/2
  const double h = 1 / static_cast<double>(steps);
  double theta = 0;
  for (long k = 0; k < steps; ++k) {
    const double middle = (static_cast<double>(k) + 0.5) * h;
    const auto rate = [&](double t) { return horner(n, t) / horner(d, t); };
    theta +=
        h / 18 * (5 * rate(middle - offset * h) + 8 * rate(middle) + 5 * rate(middle + offset * h));
    out[static_cast<std::size_t>(k + 1)] = theta;
  }
}

void steps_by_double_reflection(State& state) {
  const Curve curve = quintic();
  const DoubleCurve in_doubles(curve);
  const long steps = state.range(0);
  std::vector<Point> f2(static_cast<std::size_t>(steps + 1));
  RmfAngle angle(curve, Reference::euler_rodrigues);
  const CompiledFrames exact(curve, angle, 0, 1);
  for (auto _ : state) double_reflection(in_doubles, exact(0).e2, steps, f2);
  double error = 0;
  for (long k = 0; k <= steps; ++k) {
    const Point off = less(f2[static_cast<std::size_t>(k)], 1,
                           exact(static_cast<double>(k) / static_cast<double>(steps)).e2);
    error = std::max(error, std::sqrt(dot(off, off)));
  }
  state.counters["error"] = error;
  state.SetItemsProcessed(state.iterations() * steps);
}

/// The same steps, and f₃ too; its error is that of rounding, 2^−53.
void steps_by_compiled_frames(State& state) {
  const Curve curve = quintic();
  const long steps = state.range(0);
  std::vector<Frame<double>> frames(static_cast<std::size_t>(steps + 1));
  RmfAngle angle(curve, Reference::euler_rodrigues);
  const CompiledFrames compiled(curve, angle, 0, 1);
  for (auto _ : state)
    for (long k = 0; k <= steps; ++k)
      frames[static_cast<std::size_t>(k)] =
          compiled(static_cast<double>(k) / static_cast<double>(steps));
  state.counters["error"] = 0x1p-53;
  state.SetItemsProcessed(state.iterations() * steps);
}

/// The same in the doubles of a compiled header.
void steps_by_header(State& state) {
  const Curve curve = quintic();
  const long steps = state.range(0);
  std::vector<Frame<double>> frames(static_cast<std::size_t>(steps + 1));
  const auto at = [steps](long k) { return static_cast<double>(k) / static_cast<double>(steps); };
  for (auto _ : state)
    for (long k = 0; k <= steps; ++k) {
      Frame<double>& frame = frames[static_cast<std::size_t>(k)];
      quintic_frame(at(k), frame.e1.data(), frame.e2.data(), frame.e3.data());
    }
  RmfAngle angle(curve, Reference::euler_rodrigues);
  const CompiledFrames exact(curve, angle, 0, 1);
  double error = 0;
  for (long k = 0; k <= steps; ++k) {
    const Point off = less(frames[static_cast<std::size_t>(k)].e2, 1, exact(at(k)).e2);
    error = std::max(error, std::sqrt(dot(off, off)));
  }
  state.counters["error"] = error;
  state.SetItemsProcessed(state.iterations() * steps);
}

void steps_by_gauss(State& state) {
  const Curve curve = quintic();
  RmfAngle angle(curve, Reference::euler_rodrigues);
  const auto n = doubles(angle.rate().numerator());
  const auto d = doubles(angle.rate().denominator());
  const long steps = state.range(0);
  std::vector<double> theta(static_cast<std::size_t>(steps + 1));
  for (auto _ : state) gauss(n, d, steps, theta);
  CompiledAngle exact(angle, 0, 1);
  double error = 0;
  for (long k = 0; k <= steps; ++k)
    error = std::max(error, std::abs(theta[static_cast<std::size_t>(k)] -
                                     exact(static_cast<double>(k) / static_cast<double>(steps))));
  state.counters["error"] = error;
  state.SetItemsProcessed(state.iterations() * steps);
}

void all_m(benchmark::internal::Benchmark* b) {
  for (const long m : {2, 5, 10, 20, 40}) b->Arg(m);
}
void all_steps(benchmark::internal::Benchmark* b) {
  for (const long steps : {100, 1000, 100'000}) b->Arg(steps);
}

BENCHMARK(compile_angle)->Apply(all_m);
BENCHMARK(compile_frames)->Apply(all_m);
BENCHMARK(compile_spline)
    ->RangeMultiplier(2)
    ->Range(500, 4000)
    ->Complexity(benchmark::oN)
    ->Unit(benchmark::kMillisecond);
BENCHMARK(compiled_angle)->Apply(all_m);
BENCHMARK(compiled_frame)->Apply(all_m);
BENCHMARK(compiled_angle_array)->ArgNames({"m", "ascending"})->ArgsProduct({{2, 40}, {0, 1}});
BENCHMARK(compiled_frame_array)->ArgNames({"m", "ascending"})->ArgsProduct({{2, 40}, {0, 1}});
BENCHMARK(header_angle_array)->ArgNames({"m", "ascending"})->ArgsProduct({{2}, {0, 1}});
BENCHMARK(header_frame_array)->ArgNames({"m", "ascending"})->ArgsProduct({{2}, {0, 1}});
BENCHMARK(header_angle);
BENCHMARK(header_frame);
BENCHMARK(steps_by_double_reflection)->Apply(all_steps);
BENCHMARK(steps_by_compiled_frames)->Apply(all_steps);
BENCHMARK(steps_by_header)->Apply(all_steps);
BENCHMARK(steps_by_gauss)->Apply(all_steps);

}  // namespace
}  // namespace phrame::bench
