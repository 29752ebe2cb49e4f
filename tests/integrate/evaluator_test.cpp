#include "phrame/integrate/evaluator.hpp"

#include "phrame/algebra/error.hpp"
#include "phrame/algebra/roots.hpp"
#include "phrame/algebra/sturm.hpp"
#include "phrame/integrate/integrate.hpp"
#include "phrame/integrate/partial_fractions.hpp"
#include "phrame/integrate/quadrature.hpp"
#include "support/random.hpp"

using namespace phrame;
using test::for_samples;
using test::Random;

namespace {

std::string digits(const RationalFunction& f, const Rational& a, const Rational& b, long count) {
  Evaluator evaluator(integrate(f));
  return round_to_decimal(evaluator.value(a, b), count).value;
}

}  // namespace

TEST_CASE("definite: known constants: π/4, log 2, and 3π/4 + arctan(1/2)") {
  CHECK(digits({{1}, {1, 0, 1}}, 0, 1, 30) == "0.785398163397448309615660845820");  // π/4
  CHECK(digits({{1}, {0, 1}}, 1, 2, 30) == "0.693147180559945309417232121458");     // log 2
  // Rioboo's integral on [1, 2] (Bronstein 2005, §2.8).
  const RationalFunction f({6, 0, -3, 0, 1}, {4, 0, 5, 0, -5, 0, 1});
  RealBall expected;
  arb_atan(expected.raw(), RealBall(Rational(1, 2), 200).raw(), 200);
  expected = add(expected, multiply(pi(200), RealBall(Rational(3, 4), 200), 200), 200);
  CHECK(Evaluator(integrate(f)).difference(1, 2, 150).overlaps(expected));
}

TEST_CASE("definite: a pole between or at the ends is refused by name, a pole outside is not") {
  const Antiderivative F = integrate({{1}, {-2, 0, 1}});  // poles ±√2
  CHECK_THROWS_WITH_AS(Evaluator(F).difference(0, 2, 60), doctest::Contains("pole in"),
                       DomainError);
  CHECK_THROWS_AS(Evaluator(F).difference(2, 0, 60), DomainError);
  CHECK_NOTHROW(Evaluator(F).difference(0, 1, 60));
  const Antiderivative G = integrate({{1}, {-1, 3}});
  CHECK_THROWS_WITH_AS(Evaluator(G).difference(0, 1, 60), doctest::Contains("pole at 1/3"),
                       DomainError);
  CHECK_THROWS_AS(Evaluator(G).difference(Rational(1, 3), 1, 60), DomainError);
  CHECK_THROWS_AS(Evaluator(integrate({{1}, {0, 0, 1}})).difference(-1, 1, 60), DomainError);
  CHECK(Evaluator(integrate({{1}, {0, 0, 1}})).difference(1, 2, 60).contains(Rational(1, 2)));
}

TEST_CASE("definite: what is rational is exact") {
  Evaluator rational(integrate({{0, 4}, {1, 0, 2, 0, 1}}));  // (−2/(1 + t²))′
  CHECK(rational.value(0, 3).exact() == Rational(9, 5));
  Evaluator log(integrate({{1}, {1, 0, 1}}));
  CHECK(log.value(7, 7).exact() == Rational(0));
  CHECK_FALSE(log.value(0, 7).exact().has_value());
}

TEST_CASE("definite: logarithms that cancel are seen to cancel") {
  // An odd integrand on a symmetric interval.
  Evaluator odd(integrate({{0, 1}, {1, 0, 0, 0, 1}}));
  CHECK(odd.value(-2, 2).exact() == Rational(0));
  // An odd one whose denominator splits into factors that are exchanged.
  Evaluator split(integrate({{0, 1}, {4, 0, 0, 0, 1}}));
  CHECK(split.value(-3, 3).exact() == Rational(0));
  // w′/(w³ + w + 7)·1 with w = t² − t, w(0) = w(1); plus 1/(t+2)², which is not 0 but rational.
  const Polynomial w{0, -1, 1};
  const RationalFunction f(differentiate(w), pow(w, 3) + w + Polynomial{7});
  Evaluator composed(integrate(f + RationalFunction({1}, {4, 4, 1})));
  CHECK(composed.value(0, 1).exact() == Rational(1, 6));
  // −2·arg of α = (8 − 3t + 7t²) + i(−6 − 2t − t²): α(1) = 12 − 9i is 3/2 times α(0) = 8 − 6i.
  const Polynomial x{8, -3, 7};
  const Polynomial y{-6, -2, -1};
  Evaluator parallel(
      integrate({Rational(-2) * (x * differentiate(y) - differentiate(x) * y), x * x + y * y}));
  CHECK(parallel.value(0, 1).exact() == Rational(0));
  // log(1 + t²) from 0 to 1 is log 2, although the ratio is rational.
  Evaluator ratio(integrate({{0, 2}, {1, 0, 1}}));
  CHECK_FALSE(ratio.value(0, 1).exact().has_value());
  // The logarithm's argument returns to its value, but the path has gone around 0: not 0.
  // ∫ from −1 to 1 of 4/(t² + 1) is 2π.
  Evaluator turn(integrate({{4}, {1, 0, 1}}));
  CHECK_FALSE(turn.value(-1, 1).exact().has_value());
}

TEST_CASE("definite: what is antisymmetric about the middle of the path is 0, exactly") {
  // A cubic and a quintic of u = t(1 − t), with residues of degree 3 and 5; u(1/3) = u(2/3).
  const Polynomial u{0, 1, -1};
  const RationalFunction f(differentiate(u) * compose(Polynomial{2, 1, 7}, u),
                           compose(Polynomial{3, 1, 0, 1}, u));
  const RationalFunction g(differentiate(u), compose(Polynomial{5, -1, 0, 0, 0, 1}, u));
  for (const Form form : {Form::automatic, Form::partial_fractions, Form::rothstein_trager}) {
    const Evaluator angle(integrate(f + g, form));
    CHECK(angle.value(0, 1).exact() == Rational(0));
    CHECK(angle.value(Rational(1, 3), Rational(2, 3)).exact() == Rational(0));
    CHECK_FALSE(angle.value(0, Rational(2, 3)).exact());
    // With a phase beside, and a rational part: t + 1 + i turns by −π/4 + arctan(1/2).
    const Evaluator more(integrate(f + g + RationalFunction({0, 2}), form));
    CHECK(more.value(0, 1).exact() == Rational(1));
    const GaussianPolynomial phase{{1, 1}, {1}};
    CHECK_FALSE(angle.multiple_of_pi(0, 1, phase));
    CHECK_FALSE(angle.multiple_of_pi(0, Rational(2, 3), {{1}, {}}));
    CHECK(angle.multiple_of_pi(0, 1, {{1, -1}, {0, 1}}) == Rational(1, 2));
  }
}

TEST_CASE("definite: logarithms and arctangents of numbers that cancel are decided") {
  // 2 log 2 − log 4.
  Evaluator logs(integrate(RationalFunction({2}, {1, 1}) - RationalFunction({3}, {1, 3})));
  CHECK(logs.value(0, 1).exact() == Rational(0));
  // Machin: 4 arctan(1/5) − arctan(1/239) − π/4, from the three integrals of a/(a² + t²) on [0, 1].
  const auto arctangent = [](long a) { return RationalFunction({a}, {a * a, 0, 1}); };
  const RationalFunction four({4}, {1});
  const RationalFunction machin = four * arctangent(5) - arctangent(239) - arctangent(1);
  Evaluator arctangents(integrate(machin + RationalFunction({1}, {4, 4, 1})));
  CHECK(arctangents.value(0, 1).exact() == Rational(1, 6));
  CHECK_FALSE(arctangents.value(0, 2).exact().has_value());
  // 8 arctan(1/5) − 2 arctan(1/239) + 6·π/4 is 2π: the product of the numbers is positive, too.
  Evaluator turn(
      integrate(RationalFunction({2}, {1}) * machin + RationalFunction({8}, {1}) * arctangent(1)));
  CHECK_FALSE(turn.value(0, 1).exact().has_value());
  // Both at once, and residues ±√2 whose logarithms stay.
  Evaluator both(integrate(machin + RationalFunction({2}, {1, 1}) - RationalFunction({3}, {1, 3})));
  CHECK(both.value(0, 1).exact() == Rational(0));
  Evaluator more(integrate(machin + RationalFunction({1}, {-8, 0, 1})));
  CHECK_FALSE(more.value(0, 1).exact().has_value());
}

TEST_CASE("definite: an integral that is one argument is recognised, others are not") {
  const auto is_argument = [](const RationalFunction& f) {
    return Evaluator(integrate(f)).single_argument().has_value();
  };
  CHECK(is_argument({}));
  CHECK(is_argument({{1}, {1, 0, 1}}));                          // arg(1 + it)
  CHECK(is_argument({{-6}, {1, 0, 4}}));                         // −3·arg(1 + 2it)
  CHECK_FALSE(is_argument({{1}, {3, 0, 3}}));                    // a third of one
  CHECK_FALSE(is_argument({{1}, {2, 0, 1}}));                    // residues in ℚ(√−2)
  CHECK_FALSE(is_argument({{0, 1}, {1, 0, 1}}));                 // a logarithm
  CHECK_FALSE(is_argument({{1, 1}, {1, 0, 1}}));                 // with one
  CHECK_FALSE(is_argument({{1}, {0, 1}}));                       // real
  CHECK_FALSE(is_argument({{0, 1}, {1, 0, 2, 0, 1}}));           // rational
  CHECK_FALSE(is_argument({{2, 0, 1}, {1, 0, 1}}));              // with a polynomial
  CHECK_FALSE(is_argument({{1, 1, 1}, {7, 0, 0, 5, 0, 0, 1}}));  // residues of degree 6
}

TEST_CASE("definite: law: a sum of arguments is one, whose rate is the integrand, for every form") {
  for_samples(60, [](Random& random) {
    const auto rate = [](const Rational& k, const GaussianPolynomial& v) {
      return RationalFunction(k * (differentiate(v) * conjugate(v)).im, norm(v));
    };
    RationalFunction f;
    for (long k = random.integer(1, 3); k > 0; --k) {
      const GaussianPolynomial v = random.gaussian_polynomial(3);
      if (is_zero(v) || !gcd(v.re, v.im).is_constant()) return;
      f = f + rate(random.integer(-3, 3), v);
    }
    for (const Form form : {Form::automatic, Form::partial_fractions, Form::rothstein_trager,
                            Form::lazard_rioboo_trager}) {
      const auto argument = Evaluator(integrate(f, form)).single_argument();
      REQUIRE(argument);
      CHECK(rate(1, *argument) == f);
    }
  });
}

TEST_CASE("definite: a sum over a reducible polynomial is evaluated like any other") {
  // Σ x log(t − x) over the roots of (x² + 1)(x² + 4): an odd integrand.
  const Antiderivative F{{}, {}, {{Polynomial{4, 0, 5, 0, 1}, {0, 1}, Bivariate({{0, -1}, {1}})}}};
  Evaluator evaluator(F);
  CHECK(evaluator.value(-1, 1).enclose(100).overlaps(quadrature(differentiate(F), -1, 1, 80)));
}

TEST_CASE("definite: law: enclosures overlap Arb's quadrature, for every form") {
  for_samples(60, [](Random& random) {
    const Polynomial d = random.repeated_polynomial(2);
    const RationalFunction f(random.polynomial(6), d);
    const Rational a = random.integer(-3, 3);
    const Rational b = a + Rational(random.integer(1, 8), 4);
    if (count_real_roots(f.denominator(), closed_interval(a, b)) > 0) return;
    const RealBall expected = quadrature(f, a, b, 80);
    RealBall first;
    for (const Form form : {Form::automatic, Form::partial_fractions, Form::rothstein_trager,
                            Form::lazard_rioboo_trager}) {
      const RealBall value = Evaluator(integrate(f, form)).difference(a, b, 100);
      CHECK(value.overlaps(expected));
      CHECK(value.radius() <= (abs(value.upper()) + 1) * parse_rational("0x1p-100"));
      if (form == Form::automatic) first = value;
      CHECK(value.overlaps(first));
    }
  });
}

TEST_CASE("definite: law: all routes lead to the same value, as accurate as asked") {
  // Chebyshev's T₄₀(t − 5), whose zeros doubles do not tell in powers of t.
  Polynomial before{1};
  Polynomial chebyshev{-5, 1};
  for (long k = 1; k < 40; ++k) {
    Polynomial next = Polynomial{-10, 2} * chebyshev - before;
    before = std::exchange(chebyshev, next);
  }
  // And forty roots around 3i/2, 10⁻³ apart and less: doubles tell not one of them.
  Polynomial cluster{1};
  for (long k = 0; k < 40; ++k) {
    const Rational y = Rational(3, 2) + Rational(k, 20'000);
    cluster *= pow(Polynomial{-Rational(k * k % 41, 20'000), 1}, 2) + Polynomial{y * y};
  }
  CHECK(has_no_clear_root(cluster));
  const auto check = [](const RationalFunction& f, const Rational& a, const Rational& b) {
    const Antiderivative F = integrate(f);
    const RealBall expected = Evaluator(F).difference(a, b, 300);
    for (const auto route : {Route::automatic, Route::roots, Route::quadrature, Route::both}) {
      Evaluator evaluator(F, f);
      evaluator.set_route(route);
      for (const long bits : {40L, 130L, 60L, 90L, 200L, 250L}) {
        const RealBall value = evaluator.difference(a, b, bits);
        CHECK(value.overlaps(expected));
        CHECK(value.is_accurate(bits));
      }
    }
  };
  check({{0, 1}, chebyshev}, Rational(-1, 3), 1);
  check({{0, 1}, cluster}, Rational(-1, 3), 1);
  for_samples(8, [&](Random& random) {
    const RationalFunction f(random.polynomial(6), random.repeated_polynomial(2));
    CHECK_FALSE(has_no_clear_root(squarefree_part(f.denominator())));
    const Rational a = random.integer(-3, 3);
    const Rational b = a + Rational(random.integer(1, 8), 4);
    if (count_real_roots(f.denominator(), closed_interval(a, b)) == 0) check(f, a, b);
  });
  for (const auto route : {Route::quadrature, Route::both}) {
    Evaluator pole(integrate({{1}, {-1, 3}}));
    pole.set_route(route);
    CHECK_THROWS_WITH_AS(pole.difference(0, 1, 60), doctest::Contains("pole at 1/3"), DomainError);
  }
}

TEST_CASE("definite: law: integrals over neighbouring intervals add up; precision can rise") {
  for_samples(40, [](Random& random) {
    // Denominators without real roots: no pole anywhere.
    Polynomial d{1};
    for (long k = random.integer(1, 3); k > 0; --k)
      d *= pow(Polynomial{random.integer(1, 9), random.integer(-1, 1), 1}, random.integer(1, 2));
    Evaluator F(integrate({random.polynomial(6), d}));
    const Rational a = random.rational();
    const Rational b = random.rational();
    const Rational c = random.rational();
    for (const long bits : {60L, 500L, 100L}) {
      const RealBall sum = add(F.difference(a, b, bits), F.difference(b, c, bits), bits + 20);
      CHECK(sum.overlaps(F.difference(a, c, bits)));
    }
  });
}

TEST_CASE("definite: close ends lose no accuracy") {
  // ∫ from 0 to 10^-40 of 1/(1+t²) = 10^-40 − 10^-120/3 + …: 60 digits.
  const Rational h = parse_rational("1e-40");
  const Rational series = h - h * h * h / 3;
  CHECK(digits({{1}, {1, 0, 1}}, 0, h, 60) == round_to_decimal(series, 60).value);
}

// ∫₀¹ 2/(1 + t²) = π/2 and ∫₀¹ 1/(t − 2) = −log 2, given in fractions with and without a pole in
// common.
TEST_CASE(
    "evaluator: next to 0 values are relatively accurate, whether the poles are known or not") {
  // ∫₀ʰ t²/(1 + t⁴) = h³/3 − h⁷/7 + …, where the terms of the poles cancel each other.
  const RationalFunction f{{0, 0, 1}, {1, 0, 0, 0, 1}};
  const Evaluator evaluator(integrate(f), f);
  for (const bool is_known : {false, true}) {
    if (is_known) evaluator.difference(0, 1, 60);
    for (const long k : {20L, 200L}) {
      const RealBall value = evaluator.difference(0, power_of_two(-k), 60);
      const Rational truth = power_of_two(-3 * k) / 3 - power_of_two(-7 * k) / 7;
      CHECK(abs(value.upper() - truth) < 2 * truth * power_of_two(-60));
    }
  }
}

TEST_CASE("definite: what is known of the logarithms gives the same values") {
  const Polynomial circle{1, 0, 1};
  const Polynomial line{-2, 1};
  const RationalFunction f = RationalFunction({2}, circle) + RationalFunction({1}, line);
  const Antiderivative F = integrate(f);
  const std::vector<SimpleFraction> apart[] = {{{{2}, circle}, {{1}, line}},
                                               {{{1}, circle}, {{1}, line}, {{1}, circle}}};
  for (const auto& fractions : apart) {
    Evaluator evaluator(F, f, fractions);
    CHECK(round_to_decimal(evaluator.value(0, 1), 20).value == "0.87764914623495130981");
    CHECK_THROWS_WITH_AS(evaluator.value(0, 3), doctest::Contains("pole at 2"), DomainError);
  }
}
