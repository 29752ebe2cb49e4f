// Certified roots of high degree and of clusters, to 50 digits.
#include <benchmark/benchmark.h>

#include "curves.hpp"
#include "phrame/algebra/near_poles.hpp"

namespace phrame::inline v0::bench {
namespace {

using State = benchmark::State;
constexpr long bits = 190;

void isolate(State& state, const Polynomial& p) {
  for (auto _ : state) benchmark::DoNotOptimize(isolate_roots(p, bits));
}

/// Of σ, of degree 2m, of a random curve.
void roots_of_sigma(State& state) {
  isolate(state, sigma(random_curve(state.range(0)).preimage()));
}

/// What no certified isolation leaves out: σ and σ′ once at each root above the real axis.
void values_at_roots(State& state) {
  const Polynomial p = sigma(random_curve(state.range(0)).preimage());
  const flint::FmpzPoly f = integer_primitive_part(p);
  const flint::FmpzPoly slope = integer_primitive_part(differentiate(p));
  const Roots roots = isolate_roots(p, bits);
  ComplexBall value;
  for (auto _ : state)
    for (const ComplexBall& z : roots.upper) {
      arb_fmpz_poly_evaluate_acb(value.raw(), f.get(), z.raw(), bits);
      arb_fmpz_poly_evaluate_acb(value.raw(), slope.get(), z.raw(), bits);
    }
}

/// For values of up to 18 digits: those of σ above the real axis with the residues of θ′, by pairs
/// of doubles, beside what balls of as many bits take for the roots alone.
void poles_by_doubles(State& state) {
  const QuaternionPolynomial a = random_curve(state.range(0)).preimage();
  const Polynomial n = Rational(-2) * twist_numerator(a);
  const Polynomial d = sigma(a);
  for (auto _ : state) benchmark::DoNotOptimize(near_poles(n, d));
}
void roots_of_80_bits(State& state) {
  const Polynomial d = sigma(random_curve(state.range(0)).preimage());
  for (auto _ : state) benchmark::DoNotOptimize(isolate_roots(d, 80));
}

/// Chebyshev's Tₙ: coefficients with as many bits as the degree has, all roots in [−1, 1].
void roots_of_chebyshev(State& state) {
  Polynomial before{1};
  Polynomial p{0, 1};
  for (long k = 1; k < state.range(0); ++k) {
    Polynomial next = Polynomial{0, 2} * p - before;
    before = std::exchange(p, next);
  }
  isolate(state, p);
}

/// 1/3 ± i·10⁻ⁿ, and two others.
void roots_of_pair(State& state) {
  const Rational gap = parse_rational("1e-" + std::to_string(2 * state.range(0)));
  isolate(state, (pow(Polynomial{Rational(-1, 3), 1}, 2) + Polynomial{gap}) * Polynomial{5, 1, 1});
}

BENCHMARK(roots_of_sigma)
    ->Arg(5)
    ->Arg(20)
    ->Arg(80)
    ->Arg(200)
    ->Arg(500)
    ->Unit(benchmark::kMillisecond);
BENCHMARK(poles_by_doubles)->Arg(2)->Arg(10)->Arg(30);
BENCHMARK(roots_of_80_bits)->Arg(2)->Arg(10)->Arg(30);
BENCHMARK(values_at_roots)->Arg(20)->Arg(200)->Arg(500)->Unit(benchmark::kMillisecond);
BENCHMARK(roots_of_chebyshev)->Arg(60)->Arg(200)->Unit(benchmark::kMillisecond);
BENCHMARK(roots_of_pair)->Arg(20)->Arg(200)->Arg(1000)->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace phrame::bench
