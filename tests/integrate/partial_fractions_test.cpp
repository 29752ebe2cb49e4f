#include "phrame/integrate/partial_fractions.hpp"

#include "phrame/algebra/error.hpp"
#include "phrame/algebra/factor.hpp"
#include "support/random.hpp"

using namespace phrame;
using test::for_samples;
using test::Random;

TEST_CASE("partial fractions: 1/(t⁴ − 1), by hand") {
  const auto fractions = simple_fractions(RationalFunction({1}, {-1, 0, 0, 0, 1}));
  RationalFunction sum;
  for (const auto& [n, d] : fractions) sum = sum + RationalFunction(n, d);
  CHECK(sum == RationalFunction({1}, {-1, 0, 0, 0, 1}));
  REQUIRE(fractions.size() == 3);
  for (const auto& [n, d] : fractions) {
    const RationalFunction f(n, d);
    if (d.degree() == 2) CHECK(f == RationalFunction({Rational(-1, 2)}, {1, 0, 1}));
    if (d == Polynomial{-1, 1}) CHECK(f == RationalFunction({Rational(1, 4)}, {-1, 1}));
    if (d == Polynomial{1, 1}) CHECK(f == RationalFunction({Rational(-1, 4)}, {1, 1}));
  }
  // ∫ −1/2/(t² + 1) = Σ c(z) log(t − z), c = −1/(4z) = z/4.
  const LogSum sum_over_poles = full_partial_fraction({{Rational(-1, 2)}, {1, 0, 1}});
  CHECK(sum_over_poles.index == Polynomial{1, 0, 1});
  CHECK(sum_over_poles.residue == Polynomial{0, Rational(1, 4)});
  CHECK(is_over_poles(sum_over_poles));
}

TEST_CASE("partial fractions: improper functions and multiple poles are refused") {
  CHECK(simple_fractions({}).empty());
  CHECK_THROWS_AS(simple_fractions(RationalFunction({0, 0, 1}, {1, 0, 1})), DomainError);
  CHECK_THROWS_AS(simple_fractions(RationalFunction({1}, {1, 2, 1})), DomainError);
}

TEST_CASE("partial fractions: law: irreducible, proper, their sum and its integral are f") {
  for_samples(60, [](Random& random) {
    const Polynomial d = squarefree_part(random.nonconstant_polynomial(7));
    const RationalFunction f(random.polynomial(d.degree() - 1), d);
    RationalFunction sum;
    RationalFunction derivative;
    for (const SimpleFraction& part : simple_fractions(f)) {
      CHECK(factor(part.denominator).factors.size() == 1);
      CHECK(part.numerator.degree() < part.denominator.degree());
      sum = sum + RationalFunction(part.numerator, part.denominator);
      derivative = derivative + differentiate(full_partial_fraction(part));
    }
    CHECK(sum == f);
    CHECK(derivative == f);
  });
}
