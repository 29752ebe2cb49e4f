// The angle of a random curve, symbolically and as a number, each beside the calls of FLINT and Arb
// that no implementation of this method avoids, on numbers of FLINT's own prepared before.
#include <benchmark/benchmark.h>

#include <memory>

#include "curves.hpp"

namespace phrame::inline v0::bench {
namespace {

using State = benchmark::State;

constexpr long digits = 50;
/// What 50 digits of a value near 1 need: 167 bits, and guard bits for rounding and evaluation.
constexpr long root_bits = 208;

/// Curve file in memory → the antiderivative, checked.
void symbolic(State& state, Reference reference) {
  const std::string text = random_curve_text(state.range(0));
  for (auto _ : state) {
    RmfAngle angle(read_curve(text).curve, reference);
    benchmark::DoNotOptimize(angle.antiderivative());
  }
}
void erf_symbolic(State& state) { symbolic(state, Reference::euler_rodrigues); }
void frenet_symbolic(State& state) { symbolic(state, Reference::frenet); }

/// The antiderivative over the residues, checked; `inner` is put into the preimage of degree m/deg.
void over_residues(State& state, Form form, const Polynomial& inner) {
  const QuaternionPolynomial a = random_curve(state.range(0) / inner.degree()).preimage();
  const auto composed = [&](const Polynomial& f) { return compose(f, inner); };
  const QuaternionPolynomial preimage{composed(a.u), composed(a.v), composed(a.p), composed(a.q)};
  for (auto _ : state) {
    RmfAngle angle(preimage, Reference::euler_rodrigues, form);
    benchmark::DoNotOptimize(angle.antiderivative());
  }
}
void erf_rothstein_trager(State& state) { over_residues(state, Form::rothstein_trager, {0, 1}); }
void erf_lazard_rioboo_trager(State& state) {
  over_residues(state, Form::lazard_rioboo_trager, {0, 1});
}
void erf_composed(State& state) { over_residues(state, Form::automatic, {1, 0, -3, 1, 1}); }

/// Eleven frames on [0, 1] of a curve that is symmetric under t → 1 − t, its poles isolated anew.
void symmetric_frames(State& state) {
  const QuaternionPolynomial a = random_curve(state.range(0) / 2).preimage();
  const auto symmetric = [](const Polynomial& f) { return compose(f, {0, 1, -1}); };
  const Curve curve({symmetric(a.u), symmetric(a.v), symmetric(a.p), symmetric(a.q)});
  for (auto _ : state) {
    RmfAngle angle(curve, Reference::euler_rodrigues);
    for (long k = 0; k <= 10; ++k) {
      const auto frame = rotation_minimizing_frame(curve, angle, Rational(k, 10));
      for (const auto& e : {frame.e1, frame.e2, frame.e3})
        benchmark::DoNotOptimize(round_to_double(e));
    }
  }
}

/// The coprimality of h and σ, is D squarefree, the factors of D and 1/D′ mod D; n/D is θ′.
struct ErfCalls {
  flint::FmpzPoly h, sigma, d;
  flint::FmpqPoly slope, modulus;

  explicit ErfCalls(const Curve& curve) {
    const Polynomial denominator = rate_to_erf(curve.preimage()).denominator();
    h = integer_primitive_part(twist_numerator(curve.preimage()));
    sigma = integer_primitive_part(phrame::sigma(curve.preimage()));
    d = integer_primitive_part(denominator);
    fmpq_poly_set(modulus.get(), denominator.raw());
    fmpq_poly_derivative(slope.get(), modulus.get());
  }

  void run() {
    flint::FmpzPoly g;
    fmpz_poly_gcd(g.get(), h.get(), sigma.get());
    benchmark::DoNotOptimize(fmpz_poly_is_squarefree(d.get()));
    fmpz_poly_factor_t factors;
    fmpz_poly_factor_init(factors);
    fmpz_poly_factor(factors, d.get());
    fmpz_poly_factor_clear(factors);
    flint::FmpqPoly one, s, t;
    fmpq_poly_xgcd(one.get(), s.get(), t.get(), slope.get(), modulus.get());
  }
};

void erf_flint(State& state) {
  ErfCalls calls(random_curve(state.range(0)));
  for (auto _ : state) calls.run();
}

/// The same, and what brings the bend rate Im(g′ḡ)/|g|² and its sum with −2h/σ to lowest terms.
void frenet_flint(State& state) {
  const Curve curve = random_curve(state.range(0));
  const GaussianPolynomial g = bend_numerator(curve.preimage());
  const flint::FmpzPoly re = integer_primitive_part(g.re);
  const flint::FmpzPoly im = integer_primitive_part(g.im);
  const flint::FmpzPoly square = integer_primitive_part(norm(g));
  const flint::FmpzPoly turn = integer_primitive_part((differentiate(g) * conjugate(g)).im);
  ErfCalls calls(curve);
  flint::FmpzPoly common;
  for (auto _ : state) {
    calls.run();
    fmpz_poly_gcd(common.get(), re.get(), im.get());
    fmpz_poly_gcd(common.get(), turn.get(), square.get());
    fmpz_poly_gcd(common.get(), calls.sigma.get(), square.get());
  }
}

/// θ(1) to 50 digits, certified, from an angle already made whose roots are not isolated yet.
void value(State& state, Reference reference) {
  const Curve curve = random_curve(state.range(0));
  for (auto _ : state) {
    state.PauseTiming();
    auto angle = std::make_unique<RmfAngle>(curve, reference);
    state.ResumeTiming();
    benchmark::DoNotOptimize(round_to_decimal(angle->value(1), digits));
    state.PauseTiming();
    angle.reset();
    state.ResumeTiming();
  }
}
void erf_value(State& state) { value(state, Reference::euler_rodrigues); }
void frenet_value(State& state) { value(state, Reference::frenet); }

/// Arb's isolation of the roots of the denominator of −2h/σ, which both values rest on.
void roots_alone(State& state) {
  const Polynomial d = rate_to_erf(random_curve(state.range(0)).preimage()).denominator();
  const flint::FmpzPoly p = integer_primitive_part(d);
  acb_ptr roots = _acb_vec_init(d.degree());
  for (auto _ : state) arb_fmpz_poly_complex_roots(roots, p.get(), 0, root_bits);
  _acb_vec_clear(roots, d.degree());
}

/// Curve file in memory → θ(1) to 50 digits.
void from_scratch(State& state, Reference reference) {
  const std::string text = random_curve_text(state.range(0));
  for (auto _ : state) {
    RmfAngle angle(read_curve(text).curve, reference);
    benchmark::DoNotOptimize(round_to_decimal(angle.value(1), digits));
  }
}
void erf_from_scratch(State& state) { from_scratch(state, Reference::euler_rodrigues); }
void frenet_from_scratch(State& state) { from_scratch(state, Reference::frenet); }

/// θ at t = 0, 1/1000, …, correctly rounded to double; roots are isolated once.
void doubles(State& state) {
  RmfAngle angle(random_curve(state.range(0)), Reference::euler_rodrigues);
  long k = 0;
  for (auto _ : state)
    benchmark::DoNotOptimize(round_to_double(angle.value(Rational(++k % 1001, 1000))));
  state.SetItemsProcessed(state.iterations());
}

/// The rotation-minimizing frame at such t, nine components correctly rounded.
void frames(State& state) {
  const Curve curve = random_curve(state.range(0));
  RmfAngle angle(curve, Reference::euler_rodrigues);
  long k = 0;
  for (auto _ : state) {
    const auto frame = rotation_minimizing_frame(curve, angle, Rational(++k % 1001, 1000));
    for (const auto& e : {frame.e1, frame.e2, frame.e3})
      benchmark::DoNotOptimize(round_to_double(e));
  }
  state.SetItemsProcessed(state.iterations());
}

void all_m(benchmark::internal::Benchmark* b) {
  for (const long m : {1, 2, 3, 5, 10, 20, 40, 80}) b->Arg(m);
}
void small_m(benchmark::internal::Benchmark* b) {
  for (const long m : {1, 2, 3, 5, 10, 20}) b->Arg(m);
}

BENCHMARK(erf_symbolic)->Apply(all_m)->Arg(200);
BENCHMARK(erf_rothstein_trager)->Arg(10)->Arg(20)->Arg(40)->Unit(benchmark::kMillisecond);
BENCHMARK(erf_lazard_rioboo_trager)->Arg(10)->Arg(20)->Arg(40)->Unit(benchmark::kMillisecond);
BENCHMARK(erf_composed)->Arg(40)->Arg(80)->Unit(benchmark::kMillisecond);
BENCHMARK(symmetric_frames)->Arg(10)->Arg(30)->Arg(40)->Unit(benchmark::kMillisecond);
BENCHMARK(erf_flint)->Apply(all_m);
BENCHMARK(erf_value)->Apply(all_m)->Arg(200);
BENCHMARK(roots_alone)->Apply(all_m);
BENCHMARK(erf_from_scratch)->Apply(all_m)->Arg(200);
BENCHMARK(frenet_symbolic)->Apply(small_m);
BENCHMARK(frenet_flint)->Apply(small_m);
BENCHMARK(frenet_value)->Apply(small_m);
BENCHMARK(frenet_from_scratch)->Apply(small_m);
BENCHMARK(doubles)->Arg(2)->Arg(10);
BENCHMARK(frames)->Arg(2)->Arg(10);

}  // namespace
}  // namespace phrame::bench
