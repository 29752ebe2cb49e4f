#include "phrame/integrate/lazard_rioboo_trager.hpp"

#include "phrame/algebra/error.hpp"
#include "phrame/algebra/factor.hpp"
#include "phrame/integrate/rothstein_trager.hpp"
#include "support/random.hpp"

using namespace phrame;
using test::for_samples;
using test::Random;

namespace {

/// The subresultant of degree k in t of a and b, up to a constant factor from ℚ(x), by Euclid's
/// algorithm in ℚ(x)[t] with pseudo-division: the remainder of degree k, reduced modulo q and made
/// monic. No value where no remainder has this degree.
std::optional<Bivariate> monic_remainder(std::vector<Polynomial> a, std::vector<Polynomial> b,
                                         long k, const Polynomial& q) {
  const auto trim = [](std::vector<Polynomial>& p) {
    while (!p.empty() && p.back().is_zero()) p.pop_back();
  };
  trim(b);
  while (!b.empty() && static_cast<long>(b.size()) - 1 > k) {
    while (a.size() >= b.size()) {
      const Polynomial top = a.back();
      const std::size_t shift = a.size() - b.size();
      for (Polynomial& c : a) c *= b.back();
      for (std::size_t i = 0; i < b.size(); ++i) a[shift + i] -= top * b[i];
      trim(a);
    }
    Polynomial common;
    for (const Polynomial& c : a) common = gcd(common, c);
    for (Polynomial& c : a) c = exact_quotient(c, common);
    std::swap(a, b);
  }
  if (static_cast<long>(b.size()) - 1 != k) return std::nullopt;
  const QuotientRing ring(q);
  const Polynomial inverse = ring.divide(Polynomial{1}, ring.reduce(b.back()));
  for (Polynomial& c : b) c = ring.multiply(c, inverse);
  return Bivariate(b);
}

RationalFunction random_simple(Random& random) {
  for (;;) {
    const Polynomial d =
        squarefree_part(random.nonconstant_polynomial(4) * random.nonzero_polynomial(2));
    const RationalFunction f(random.polynomial(d.degree() - 1), d);
    if (!f.is_zero() && f.is_proper()) return f;
  }
}

}  // namespace

TEST_CASE("Lazard–Rioboo–Trager: Bronstein's example has the subresultant of degree 3") {
  // (x⁴ − 3x² + 6)/(x⁶ − 5x⁴ + 5x² + 4): Q₃ = 4α² + 1, v = x³ + 2αx² − 3x − 4α
  // [Bronstein 2005, examples 2.4.1 and 2.5.1].
  const auto sums = lazard_rioboo_trager({{6, 0, -3, 0, 1}, {4, 0, 5, 0, -5, 0, 1}});
  REQUIRE(sums.size() == 1);
  CHECK(sums[0] == LogSum{{1, 0, 4}, {0, 1}, Bivariate({{0, -4}, {-3}, {0, 2}, {1}})});
}

TEST_CASE("Lazard–Rioboo–Trager: nothing is factored: one sum for each number of poles") {
  // 1/t + 2/(t − 1) + 3·(t³ + t + 1)′/(t³ + t + 1): residues 1 and 2 once, 3 at three poles.
  const RationalFunction f = RationalFunction({1}, {0, 1}) + RationalFunction({2}, {-1, 1}) +
                             RationalFunction({3, 0, 9}, {1, 1, 0, 1});
  const auto sums = lazard_rioboo_trager(f);
  REQUIRE(sums.size() == 2);
  CHECK(sums[0].index == Polynomial{-3, 1});
  CHECK(sums[0].argument == Bivariate({{1}, {1}, {}, {1}}));
  CHECK(sums[1].index == Polynomial{2, -3, 1});
  CHECK(sums[1].argument == Bivariate({{1, -1}, {1}}));  // t at 1, t − 1 at 2
  CHECK(lazard_rioboo_trager({}).empty());
  CHECK_THROWS_AS(lazard_rioboo_trager({{1}, {0, 0, 1}}), DomainError);
  CHECK_THROWS_AS(lazard_rioboo_trager({{0, 1}, {1}}), DomainError);
}

TEST_CASE("Lazard–Rioboo–Trager: 120 poles with two residues") {
  // 5p′/p − (7/3)q′/q with p and q of degree 60.
  Random random(1);
  const auto of_degree_60 = [&] {
    std::vector<Rational> c;
    for (int k = 0; k < 60; ++k) c.emplace_back(random.integer(-99, 99));
    c.emplace_back(1);
    return Polynomial(c);
  };
  const Polynomial p = of_degree_60();
  const Polynomial q = of_degree_60();
  const RationalFunction f(
      Rational(5) * (differentiate(p) * q) - Rational(7, 3) * (differentiate(q) * p), p * q);
  REQUIRE(f.denominator().degree() == 120);
  const auto sums = lazard_rioboo_trager(f);
  REQUIRE(sums.size() == 1);
  CHECK(sums[0].index == Polynomial{-35, -8, 3});
  CHECK(sums[0].argument.degree() == 60);
  CHECK(differentiate(sums[0]) == f);
  for (long k = 0; k <= 60; ++k) {
    CHECK(sums[0].argument.coefficient(k)(5) == p.coefficient(k));
    CHECK(sums[0].argument.coefficient(k)(Rational(-7, 3)) == q.coefficient(k));
  }
}

TEST_CASE("Lazard–Rioboo–Trager: law: the arguments are the subresultants, made monic") {
  long compared = 0;
  for_samples(60, [&](Random& random) {
    const RationalFunction f = random_simple(random);
    const auto sums = lazard_rioboo_trager(f);
    RationalFunction derivative;
    for (const LogSum& sum : sums) derivative = derivative + differentiate(sum);
    CHECK(derivative == f);
    std::vector<Polynomial> a;
    std::vector<Polynomial> b;
    const Polynomial slope = differentiate(f.denominator());
    for (long k = 0; k <= f.denominator().degree(); ++k) {
      a.push_back({f.denominator().coefficient(k)});
      b.push_back({f.numerator().coefficient(k), -slope.coefficient(k)});
    }
    for (const LogSum& sum : sums) {
      const long k = sum.argument.degree();
      if (k == f.denominator().degree()) continue;  // it is d itself
      const auto expected = monic_remainder(a, b, k, sum.index);
      REQUIRE(expected.has_value());
      CHECK(sum.argument == *expected);
      ++compared;
    }
  });
  CHECK(compared > 40);
}

TEST_CASE("Lazard–Rioboo–Trager: law: for one irreducible factor it is Rothstein–Trager's gcd") {
  for_samples(40, [](Random& random) {
    for (const SimpleFraction& f : simple_fractions(random_simple(random))) {
      const auto sums = lazard_rioboo_trager({f.numerator, f.denominator});
      REQUIRE(sums.size() == 1);
      CHECK(sums[0] == rothstein_trager(f));
    }
  });
}
