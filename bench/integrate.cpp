// The integrator on random rational functions n/d; the first argument is the degree of d. Beside
// the residue polynomial what one would write without it: FLINT's bivariate resultant, and values
// of the resultant interpolated. `proved/needed` is Hadamard's bound over the bits of the longest
// coefficient of the result.
#include <benchmark/benchmark.h>
#include <flint/fmpz_mpoly.h>
#include <flint/fmpz_vec.h>

#include <random>

#include "curves.hpp"
#include "phrame/algebra/hadamard.hpp"
#include "phrame/algebra/resultant.hpp"
#include "phrame/integrate/lazard_rioboo_trager.hpp"
#include "phrame/integrate/rothstein_trager.hpp"

namespace phrame::inline v0::bench {
namespace {

using State = benchmark::State;

/// Coefficients of exactly `bits` bits and random signs, the same in every run.
Polynomial random_polynomial(long degree, long bits) {
  std::mt19937_64 engine(static_cast<unsigned long>(degree));
  std::vector<Rational> c;
  for (long k = 0; k <= degree; ++k) {
    Integer n = 1;
    for (long bit = 1; bit < bits; ++bit) n = 2 * n + static_cast<long>(engine() >> 63U);
    c.emplace_back(engine() % 2 == 0 ? n : Integer(-n));
  }
  return Polynomial(c);
}

RationalFunction generic(long degree, long bits) {
  return {random_polynomial(degree - 1, bits), random_polynomial(degree, bits)};
}

/// The derivative of atan(a/b): two residues, ±i/2.
RationalFunction few_residues(long degree, long bits) {
  const Polynomial a = random_polynomial(degree / 2, bits);
  const Polynomial b = random_polynomial(degree / 2 - 1, bits);
  return {differentiate(a) * b - a * differentiate(b), a * a + b * b};
}

/// A third of the degree in poles of order three.
RationalFunction repeated_factors(long degree, long bits) {
  return {random_polynomial(degree - 1, bits), pow(random_polynomial(degree / 3, bits), 3)};
}

void integrate(State& state, RationalFunction (*make)(long degree, long bits)) {
  const RationalFunction f = make(state.range(0), state.range(1));
  for (auto _ : state) benchmark::DoNotOptimize(phrame::integrate(f));
}
void integrate_generic(State& state) { integrate(state, generic); }
void integrate_few_residues(State& state) { integrate(state, few_residues); }
void integrate_repeated(State& state) { integrate(state, repeated_factors); }

long longest(const Polynomial& f) {
  flint::FmpzPoly numerator;
  fmpq_poly_get_numerator(numerator.get(), f.raw());
  return std::labs(fmpz_poly_max_bits(numerator.get()));
}

/// All residues n/d′ modulo d.
void residues_at_poles(State& state) {
  const RationalFunction f = generic(state.range(0), state.range(1));
  const SimpleFraction part{f.numerator(), f.denominator()};
  for (auto _ : state) benchmark::DoNotOptimize(full_partial_fraction(part));
  const flint::FmpzPoly d = integer_primitive_part(part.denominator);
  const long proved = cofactor_bits(integer_primitive_part(part.numerator),
                                    integer_primitive_part(differentiate(part.denominator)), d);
  state.counters["proved/needed"] =
      static_cast<double>(proved) /
      static_cast<double>(longest(full_partial_fraction(part).residue));
}

/// The same by Euclid's algorithm of FLINT over ℚ and a product.
void residues_at_poles_xgcd(State& state) {
  const RationalFunction f = generic(state.range(0), state.range(1));
  const Polynomial slope = differentiate(f.denominator());
  for (auto _ : state) {
    Polynomial one;
    Polynomial inverse;
    Polynomial rest;
    fmpq_poly_xgcd(one.raw(), inverse.raw(), rest.raw(), slope.raw(), f.denominator().raw());
    benchmark::DoNotOptimize((f.numerator() * inverse) % f.denominator());
  }
}

void residue_generic(State& state) {
  const RationalFunction f = generic(state.range(0), state.range(1));
  Polynomial r;
  for (auto _ : state) r = residue_polynomial(f.numerator(), f.denominator());
  const long proved =
      residue_bits(integer_primitive_part(f.numerator()), integer_primitive_part(f.denominator()));
  state.counters["proved/needed"] = static_cast<double>(proved) / static_cast<double>(longest(r));
}

/// fmpz_mpoly_resultant of n − x·d′ and d in ℤ[t, x].
void residue_mpoly(State& state) {
  const RationalFunction f = generic(state.range(0), state.range(1));
  const flint::FmpzPoly n = integer_primitive_part(f.numerator());
  const flint::FmpzPoly d = integer_primitive_part(f.denominator());
  flint::FmpzPoly slope;
  fmpz_poly_derivative(slope.get(), d.get());
  fmpz_mpoly_ctx_t context;
  fmpz_mpoly_ctx_init(context, 2, ORD_LEX);
  fmpz_mpoly_t a;
  fmpz_mpoly_t b;
  fmpz_mpoly_t r;
  fmpz_mpoly_init(a, context);
  fmpz_mpoly_init(b, context);
  fmpz_mpoly_init(r, context);
  flint::Fmpz c;
  const auto set = [&](fmpz_mpoly_struct* p, const flint::FmpzPoly& coefficients, ulong x_power) {
    for (slong k = 0; k < fmpz_poly_length(coefficients.get()); ++k) {
      const ulong exponents[] = {static_cast<ulong>(k), x_power};
      fmpz_poly_get_coeff_fmpz(c.get(), coefficients.get(), k);
      fmpz_mpoly_set_coeff_fmpz_ui(p, c.get(), static_cast<const ulong*>(exponents), context);
    }
  };
  fmpz_poly_neg(slope.get(), slope.get());
  set(a, n, 0);
  set(a, slope, 1);
  set(b, d, 0);
  for (auto _ : state) benchmark::DoNotOptimize(fmpz_mpoly_resultant(r, a, b, 0, context));
  fmpz_mpoly_clear(a, context);
  fmpz_mpoly_clear(b, context);
  fmpz_mpoly_clear(r, context);
  fmpz_mpoly_ctx_clear(context);
}

/// The resultants of n − x·d′ and d at x = 0, 1, …, deg d, interpolated over ℤ.
void residue_interpolated(State& state) {
  const RationalFunction f = generic(state.range(0), state.range(1));
  const flint::FmpzPoly d = integer_primitive_part(f.denominator());
  const slong count = state.range(0) + 1;
  fmpz* xs = _fmpz_vec_init(count);
  fmpz* ys = _fmpz_vec_init(count);
  flint::FmpzPoly slope;
  flint::FmpzPoly r;
  fmpz_poly_derivative(slope.get(), d.get());
  for (auto _ : state) {
    flint::FmpzPoly row = integer_primitive_part(f.numerator());
    for (slong x = 0; x < count; ++x) {
      fmpz_set_si(xs + x, x);
      fmpz_poly_resultant(ys + x, row.get(), d.get());
      fmpz_poly_sub(row.get(), row.get(), slope.get());
    }
    fmpz_poly_interpolate_fmpz_vec(r.get(), xs, ys, count);
  }
  _fmpz_vec_clear(xs, count);
  _fmpz_vec_clear(ys, count);
}

/// Degrees 4, 8, …, last.
template <long last, long bits>
void degrees(benchmark::internal::Benchmark* b) {
  for (long n = 4; n <= last; n *= 2) b->Args({n, bits});
}

constexpr auto ms = benchmark::kMillisecond;
BENCHMARK(integrate_generic)->Apply(degrees<256, 20>)->Apply(degrees<64, 1000>)->Unit(ms);
BENCHMARK(integrate_few_residues)->Apply(degrees<64, 20>)->Unit(ms);
BENCHMARK(integrate_repeated)
    ->Args({6, 20})
    ->Args({12, 20})
    ->Args({24, 20})
    ->Args({48, 20})
    ->Unit(ms);
BENCHMARK(residues_at_poles)->Apply(degrees<256, 20>)->Apply(degrees<64, 1000>)->Unit(ms);
BENCHMARK(residues_at_poles_xgcd)->Apply(degrees<256, 20>)->Apply(degrees<64, 1000>)->Unit(ms);
BENCHMARK(residue_generic)
    ->Apply(degrees<128, 20>)
    ->Args({48, 20})
    ->Args({200, 20})
    ->Apply(degrees<32, 1000>)
    ->Unit(ms);
BENCHMARK(residue_mpoly)->Apply(degrees<16, 20>)->Unit(ms);
BENCHMARK(residue_interpolated)->Apply(degrees<64, 20>)->Unit(ms);

}  // namespace
}  // namespace phrame::bench
