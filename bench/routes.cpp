// The ways to one value, ∫₀¹ of the rate to 50 digits with nothing kept from before, for curves of
// many kinds: --route auto is to be within half as much again of the better of the two others.
#include <benchmark/benchmark.h>

#include <functional>
#include <utility>

#include "curves.hpp"

namespace phrame::inline v0::bench {
namespace {

QuaternionPolynomial mapped(const QuaternionPolynomial& a,
                            const std::function<Polynomial(const Polynomial&)>& map) {
  return {map(a.u), map(a.v), map(a.p), map(a.q)};
}

QuaternionPolynomial composed(const QuaternionPolynomial& a, const Polynomial& g) {
  return mapped(a, [&](const Polynomial& p) { return compose(p, g); });
}

/// Integer Bernstein coefficients.
QuaternionPolynomial in_bernstein_form(long m) {
  return mapped(random_curve(m).preimage(),
                [](const Polynomial& p) { return from_bernstein(p.coefficients()); });
}

/// (t − 1/2)·B + ε·C.
QuaternionPolynomial near_cusp(long m, const char* epsilon) {
  const Polynomial zero{Rational(-1, 2), 1};
  const QuaternionPolynomial b = random_curve(m - 1).preimage();
  const auto part = [&](const Polynomial& p, long c) {
    return zero * p + Polynomial{c * parse_rational(epsilon)};
  };
  return {part(b.u, 3), part(b.v, -2), part(b.p, 1), part(b.q, 4)};
}

/// All roots of σ within about 10⁻² of 1/2 ± i.
QuaternionPolynomial clustered(long m) {
  GaussianPolynomial product{{1}, {}};
  for (long k = 0; k < m; ++k) {
    const Rational x = Rational(1, 2) + Rational(k * k % 19 - 9, 1000);
    const Rational y = 1 + Rational(k * k * k % 17 - 8, 1000);
    product = product * GaussianPolynomial{{-x, 1}, {-y}};
  }
  return {product.re, product.im, {}, Polynomial{power_of_ten(-3 * m)}};
}

/// Chebyshev's, of degree n.
Polynomial chebyshev(long n) {
  Polynomial before{1};
  Polynomial last{0, 1};
  for (long k = 1; k < n; ++k) {
    Polynomial next = Polynomial{0, 2} * last - before;
    before = std::exchange(last, std::move(next));
  }
  return last;
}

void value(benchmark::State& state, const QuaternionPolynomial& a, Route route) {
  const RationalFunction rate = rate_to_erf(a);
  const Antiderivative F = integrate(rate, Form::partial_fractions);
  try {
    for (auto _ : state) {
      Evaluator evaluator(F, rate);
      evaluator.set_route(route);
      benchmark::DoNotOptimize(evaluator.difference(0, 1, 170));
    }
  } catch (const Undecided&) {
    state.SkipWithError("no value");
  }
}

void add(const std::string& kind, const QuaternionPolynomial& a) {
  const std::pair<const char*, Route> routes[] = {
      {"auto", Route::automatic}, {"roots", Route::roots}, {"quadrature", Route::quadrature}};
  for (const auto& named : routes)
    benchmark::RegisterBenchmark(
        ("route/" + kind + "/" + named.first).c_str(),
        [a, route = named.second](benchmark::State& state) { value(state, a, route); })
        ->Unit(benchmark::kMillisecond);
}

const bool is_registered = [] {
  for (const long m : {2, 5, 10, 20, 40})
    add("random " + std::to_string(m), random_curve(m).preimage());
  for (const long m : {10, 20, 40}) add("bernstein " + std::to_string(m), in_bernstein_form(m));
  for (const long m : {2, 5, 10})
    add("composed " + std::to_string(4 * m), composed(random_curve(m).preimage(), chebyshev(4)));
  add("composed 40, twenty-fold", composed(random_curve(2).preimage(), chebyshev(20)));
  for (const char* epsilon : {"1e-3", "1e-9", "1e-30", "1e-100", "1e-300", "1e-1000"})
    add(std::string("near-cusp ") + epsilon, near_cusp(2, epsilon));
  for (const char* epsilon : {"1e-3", "1e-30", "1e-300"})
    add(std::string("near-cusp 20, ") + epsilon, near_cusp(20, epsilon));
  const Polynomial twice = compose(chebyshev(5), chebyshev(5));
  add("near-cusp 1e-9 of T5", composed(near_cusp(2, "1e-9"), chebyshev(5)));
  add("near-cusp 1e-9 of T5 of T5", composed(near_cusp(2, "1e-9"), twice));
  for (const long m : {5, 20, 30, 40, 60}) add("cluster " + std::to_string(m), clustered(m));
  return true;
}();

}  // namespace
}  // namespace phrame::bench
