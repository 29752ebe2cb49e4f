#include "phrame/algebra/error.hpp"
#include "phrame/integrate/rothstein_trager.hpp"
#include "support/random.hpp"

using namespace phrame;
using test::for_samples;
using test::Random;

TEST_CASE("partial fractions: over ℚ the parts add up, one for each irreducible factor") {
  const RationalFunction f({1}, {0, -1, 0, 1});  // 1/(t³ − t) = −1/t + 1/(2(t−1)) + 1/(2(t+1))
  const auto parts = simple_fractions(f);
  REQUIRE(parts.size() == 3);
  RationalFunction sum;
  for (const auto& [n, d] : parts) sum = sum + RationalFunction(n, d);
  CHECK(sum == f);
  CHECK(parts[0].numerator == Polynomial{-1});
  CHECK(simple_fractions({}).empty());
  CHECK_THROWS_AS(simple_fractions(RationalFunction({1}, {0, 0, 1})), DomainError);
  CHECK_THROWS_AS(simple_fractions(RationalFunction({0, 1})), DomainError);
}

TEST_CASE("full partial fractions: ∫ dt/(t² + 1): the residue at z = ±i is 1/(2z) = −z/2") {
  const LogSum sum = full_partial_fraction({{1}, {1, 0, 1}});
  CHECK(sum.residue == Polynomial{0, Rational(-1, 2)});
  CHECK(is_over_poles(sum));
}

TEST_CASE("Rothstein–Trager: Trager's example: 36/(t⁵ − 2t⁴ − 2t³ + 4t² + t − 2)") {
  // = 12/(t − 1)² + … ; its simple part is 4/(t − 2) − 4/(t + 1): the residues are ±4.
  const LogSum minus = rothstein_trager({{{-4}, {1, 1}}}).front();
  CHECK(minus.index == Polynomial{4, 1});
  CHECK(minus.argument == Bivariate({Polynomial{1}, Polynomial{1}}));
}

TEST_CASE(
    "Rothstein–Trager: the arctangent in (t⁴ − 3t² + 6)/(t⁶ − 5t⁴ + 5t² + 4) has residues ±i/2") {
  // Bronstein 2005, example 2.4.1: R = (4x² + 1)³ up to a constant, v = t³ + 2xt² − 3t − 4x.
  const LogSum sum = rothstein_trager({{{6, 0, -3, 0, 1}, {4, 0, 5, 0, -5, 0, 1}}}).front();
  CHECK(sum.index == Polynomial{1, 0, 4});
  CHECK(sum.argument ==
        Bivariate({Polynomial{0, -4}, Polynomial{-3}, Polynomial{0, 2}, Polynomial{1}}));
}

TEST_CASE("Rothstein–Trager: d′/d is log d whatever d is") {
  const Polynomial d{2, 0, 0, 0, 0, 1};  // t⁵ + 2, irreducible (Eisenstein)
  const LogSum sum = rothstein_trager({{differentiate(d), d}}).front();
  CHECK(sum.index == Polynomial{-1, 1});
  std::vector<Polynomial> expected(6);
  expected[0] = {2};
  expected[5] = {1};
  CHECK(sum.argument == Bivariate(expected));
}

TEST_CASE("Rothstein–Trager: law: both forms differentiate to n/d, also composed with t^k") {
  for_samples(60, [](Random& random) {
    const Polynomial base = squarefree_part(random.nonconstant_polynomial(4));
    const Polynomial inner = Polynomial::monomial(1, random.integer(1, 3)) + Polynomial{3};
    // n(w)w′/d(w): the residues of n/d, each met deg w times.
    const Polynomial d = compose(base, inner);
    if (!is_squarefree(d)) return;
    const Polynomial n = compose(random.polynomial(3) % base, inner) * differentiate(inner);
    const RationalFunction f(n, d);
    for (const auto& part : simple_fractions(f)) {
      const RationalFunction g(part.numerator, part.denominator);
      CHECK(differentiate(full_partial_fraction(part)) == g);
      const LogSum sum = rothstein_trager({part}).front();
      CHECK(differentiate(sum) == g);
      CHECK(sum.index.degree() * sum.argument.degree() == part.denominator.degree());
    }
  });
}

TEST_CASE("equal residues: sums over the same residues are joined, their arguments multiplied") {
  const std::vector<SimpleFraction> fractions = {{{1}, {1, 1}}, {{1}, {0, 1}}, {{2}, {5, 1}}};
  std::vector<LogSum> sums;
  for (const SimpleFraction& f : fractions) sums.push_back(rothstein_trager({f}).front());
  const auto merged = merge_equal_residues(sums);
  REQUIRE(merged.size() == 2);
  CHECK(merged[0].argument == Bivariate({Polynomial{}, Polynomial{1}, Polynomial{1}}));
  CHECK(merged == rothstein_trager(fractions));
}

TEST_CASE("equal residues: three poles of 1/(t³ + t + 1) and as many of its shifted self") {
  const Polynomial d{1, 1, 0, 1};
  const Polynomial shifted = compose(d, {2, 1});
  const std::vector<SimpleFraction> fractions = {{{1}, d}, {{1}, shifted}, {{1}, {5, 0, 0, 1}}};
  const auto groups = by_residues(fractions);
  REQUIRE(groups.size() == 2);
  CHECK_FALSE(groups[0].is_one);
  CHECK(groups[1].is_one);
  CHECK(groups[0].residues.degree() == 6);
  const auto sums = over_residues(fractions);
  REQUIRE(sums.size() == 2);
  CHECK(sums[0].argument.degree() == 2);
  CHECK(differentiate(sums[0]) == RationalFunction({1}, d) + RationalFunction({1}, shifted));
}

TEST_CASE("equal residues: fractions with the same poles are one, or none") {
  // 1/(t² + 1) twice has the residues ±i, not ±i/2 at two poles each.
  const SimpleFraction f{{1}, {1, 0, 1}};
  const auto twice = over_residues({f, {{1}, {0, 1}}, f});
  REQUIRE(twice.size() == 2);
  CHECK(twice[0].index == Polynomial{1, 0, 1});
  CHECK(twice[0].argument.degree() == 1);
  CHECK(differentiate(twice[0]) == RationalFunction({2}, {1, 0, 1}));
  CHECK(over_residues({f, {{-1}, {1, 0, 1}}}).empty());
}
