// Single algorithms of the symbolic stage. The argument is the degree of the denominator.
#include <benchmark/benchmark.h>

#include "curves.hpp"
#include "phrame/algebra/resultant.hpp"
#include "phrame/integrate/hermite.hpp"
#include "phrame/integrate/lazard_rioboo_trager.hpp"
#include "phrame/integrate/rothstein_trager.hpp"

namespace phrame::inline v0::bench {
namespace {

using State = benchmark::State;

/// res_t(n − x·d′, d) of the ERF rate of a random curve.
void residue_polynomial(State& state) {
  const RationalFunction f = rate_to_erf(random_curve(state.range(0) / 2).preimage());
  for (auto _ : state)
    benchmark::DoNotOptimize(phrame::residue_polynomial(f.numerator(), f.denominator()));
}

/// One prime mostly shows that it is squarefree.
void residues_are_distinct(State& state) {
  const RationalFunction f = rate_to_erf(random_curve(state.range(0) / 2).preimage());
  for (auto _ : state)
    benchmark::DoNotOptimize(residues_are_distinct_modulo_a_prime(f.numerator(), f.denominator()));
}

/// The rational part of ∫ ρ/σ³, the bending energy of a random curve: a pole of order three.
void hermite(State& state) {
  const Curve curve = random_curve(state.range(0) / 6);
  const RationalFunction f(rho(curve.preimage()), pow(sigma(curve.preimage()), 3));
  for (auto _ : state) benchmark::DoNotOptimize(hermite_reduce(f));
}

BENCHMARK(residue_polynomial)->Arg(4)->Arg(8)->Arg(16)->Arg(32)->Arg(64)->Arg(96);
BENCHMARK(residues_are_distinct)->Arg(4)->Arg(8)->Arg(16)->Arg(32)->Arg(64)->Arg(96);
BENCHMARK(hermite)->Arg(6)->Arg(12)->Arg(30)->Arg(60);

}  // namespace
}  // namespace phrame::bench
