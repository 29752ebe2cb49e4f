#include "phrame/integrate/gaussian_logs.hpp"

#include "phrame/integrate/integrate.hpp"
#include "support/random.hpp"

using namespace phrame;
using test::for_samples;
using test::Random;

TEST_CASE("Gaussian residues: 1/t, t/(t² + 4), 1/(t² + 4) and 1/(t² − 2)") {
  const auto of = [](const RationalFunction& f) {
    return gaussian_logs(integrate(f, Form::rothstein_trager).logs);
  };
  CHECK(of({{1}, {0, 1}}).logarithms == std::vector<GaussianLogs::Logarithm>{{1, {0, 1}}});
  CHECK(of({{0, 1}, {4, 0, 1}}).logarithms ==
        std::vector<GaussianLogs::Logarithm>{{Rational(1, 2), {4, 0, 1}}});
  // arctan(t/2)/2: residues ∓i/4 at ±2i, v(i/4, t) = t + 2i.
  CHECK(of({{1}, {4, 0, 1}}).arguments ==
        std::vector<GaussianLogs::Argument>{{Rational(-1, 2), {{0, 1}, {2}}}});
  CHECK(of({{1}, {-2, 0, 1}}).others.size() == 1);
}

TEST_CASE("Gaussian residues: whole multiples of arguments are one argument") {
  const auto of = [](const RationalFunction& f) {
    return single_argument(gaussian_logs(integrate(f, Form::rothstein_trager).logs));
  };
  CHECK(of({}) == GaussianPolynomial{{1}, {}});
  // −3·arctan(t/2) = 3·arg(t + 2i) + constant; a sixth of that is no argument.
  const GaussianPolynomial v{{0, 1}, {2}};
  CHECK(of({{-6}, {4, 0, 1}}) == v * v * v);
  CHECK_FALSE(of({{1}, {4, 0, 1}}));
  CHECK_FALSE(of({{6, 1}, {4, 0, 1}}));  // and a logarithm
  CHECK_FALSE(of({{1}, {2, 0, 1}}));     // residues ±i/√8
}

TEST_CASE("Gaussian residues: law: its derivative is the integrand") {
  for_samples(100, [](Random& random) {
    // Residues p ± iq at the roots of (t − a)² + b², p at real ones.
    RationalFunction f;
    for (long k = random.integer(1, 4); k > 0; --k) {
      const Rational a = random.integer(-9, 9);
      const Rational b = random.integer(0, 4);
      const Rational p = random.rational();
      f = f + (b == 0 ? RationalFunction({p}, {-a, 1})
                      : RationalFunction({random.rational(), p}, {a * a + b * b, -2 * a, 1}));
    }
    if (f.is_zero()) return;
    const Antiderivative F = integrate(f, Form::rothstein_trager);
    const GaussianLogs form = gaussian_logs(F.logs);
    RationalFunction derivative = differentiate(F.rational);
    for (const auto& [factor, v] : form.logarithms)
      derivative = derivative + RationalFunction(factor * differentiate(v), v);
    for (const auto& [factor, v] : form.arguments)
      derivative =
          derivative + RationalFunction(factor * (differentiate(v) * conjugate(v)).im, norm(v));
    for (const LogSum& sum : form.others) derivative = derivative + differentiate(sum);
    CHECK(derivative == f);
  });
}
