#include "phrame/integrate/integral_sum.hpp"

#include "phrame/integrate/integrate.hpp"
#include "phrame/integrate/quadrature.hpp"
#include "support/random.hpp"

using namespace phrame;
using test::for_samples;
using test::Random;

namespace {

/// factor · ∫ f, known as far as definite_integral() knows it.
KnownIntegral integral(const RationalFunction& f, const Rational& from, const Rational& to,
                       const Rational& factor = 1) {
  const DefiniteIntegral whole = definite_integral(f, from, to);
  KnownIntegral known{{Real(factor) * whole.value, std::nullopt},
                      {{f, integrate(f), from, to, factor}}};
  if (whole.exact) known.value.exact = factor * *whole.exact;
  return known;
}

const RationalFunction circle({1}, {1, 0, 1});

}  // namespace

TEST_CASE("integral sum: arctangents of different integrals make a multiple of pi") {
  const Rational half(1, 2);
  const DefiniteIntegral quarter =
      sum_of_integrals({integral(circle, 0, half), integral(circle, half, 1)});
  CHECK(quarter.exact == ExactValue{0, Rational(1, 4), {}, {}});
  CHECK_FALSE(quarter.value.exact());
  const DefiniteIntegral nothing = sum_of_integrals(
      {integral(circle, 0, half), integral(circle, half, 1), integral(circle, 0, 1, -1)});
  CHECK(nothing.value.exact() == Rational(0));
  CHECK(sum_of_integrals({}).value.exact() == Rational(0));
}

// With u = t − t² it is ∫ du/(u³ + u + 1), from 0 to 0. The residues are in a cubic field, so that
// neither part is known in finite terms.
TEST_CASE("integral sum: logarithms over any field that cancel are seen to") {
  const Polynomial u{0, 1, -1};
  const RationalFunction f({1, -2}, u * u * u + u + Polynomial{1});
  const Rational third(1, 3);
  const RationalFunction more = f + RationalFunction(Polynomial{0, 0, 3});
  REQUIRE_FALSE(integral(f, 0, third).value.exact);
  const DefiniteIntegral sum = sum_of_integrals({integral(f, 0, third), integral(more, third, 1)});
  CHECK(sum.value.exact() == Rational(26, 27));
  CHECK(sum.exact == ExactValue{Rational(26, 27), 0, {}, {}});
  CHECK(sum_of_integrals({integral(f, 0, third), integral(f, third, Rational(1, 2))})
            .value.origin()
            .is_irrational);
}

// ∫ 1/(t² − t + 1) = 2π/√27.
TEST_CASE("integral sum: two irrational multiples of pi") {
  const RationalFunction f({1}, {1, -1, 1});
  const RationalFunction g({2}, {4, -2, 1});  // ∫ from 0 to 2 is the same
  REQUIRE(integral(f, 0, 1).value.exact->irrational_pi);
  CHECK(sum_of_integrals({integral(f, 0, 1), integral(g, 0, 2, -1)}).value.exact() == Rational(0));
  const DefiniteIntegral twice = sum_of_integrals({integral(f, 0, 1), integral(g, 0, 2)});
  CHECK(twice.value.origin().is_irrational);
  CHECK(round_to_decimal(twice.value, 20).value == "2.4183991523122904675");
}

TEST_CASE("integral sum: law: it is the integral of the sum") {
  for_samples(30, [](Random& random) {
    const auto positive = [&] {
      const Polynomial p = random.polynomial(2);
      return p * p + Polynomial{Rational(1, random.integer(1, 9))};
    };
    const RationalFunction f(random.polynomial(3), positive());
    const RationalFunction g(random.polynomial(3), positive());
    const Rational c(random.integer(-3, 3));
    const DefiniteIntegral sum = sum_of_integrals({integral(f, 0, 1), integral(g, 0, 1, c)});
    const RationalFunction both = f + RationalFunction(Polynomial{c}) * g;
    CHECK(sum.value.enclose(100).overlaps(quadrature(both, 0, 1, 60)));
  });
}
