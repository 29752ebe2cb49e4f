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

/// v over its leading coefficient, modulo q.
Bivariate made_monic(const Bivariate& v, const Polynomial& q) {
  const QuotientRing ring(q);
  const Polynomial inverse = ring.divide({1}, v.coefficient(v.degree()));
  std::vector<Polynomial> rows;
  for (const Polynomial& c : v.coefficients()) rows.push_back(ring.multiply(c, inverse));
  return Bivariate(rows);
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
      CHECK(made_monic(sum.argument, sum.index) == *expected);
      ++compared;
    }
  });
  CHECK(compared > 40);
}

TEST_CASE("Lazard–Rioboo–Trager: law: for one irreducible factor it is Rothstein–Trager's sum") {
  for_samples(40, [](Random& random) {
    for (const SimpleFraction& f : simple_fractions(random_simple(random)))
      CHECK(lazard_rioboo_trager({f.numerator, f.denominator}) == rothstein_trager({f}));
  });
}

TEST_CASE("Lazard–Rioboo–Trager: v(α, t) is q′(α)·t − N(α) where that is shorter than monic") {
  const auto sums = lazard_rioboo_trager({{1}, {-53, 71, -83, 0, 0, 0, 97}});
  REQUIRE(sums.size() == 1);
  const auto& [q, residue, v] = sums[0];
  REQUIRE(v.degree() == 1);
  const Polynomial slope = differentiate(q);
  CHECK(v.coefficient(1) == (1 / content(slope)) * slope);
  CHECK(primitive_bits(made_monic(v, q).coefficient(0)) > 2 * primitive_bits(v.coefficient(0)));
  // 1/(t⁸ + 1): c = −z/8, z = −8c.
  const auto of_unity = lazard_rioboo_trager({{1}, {1, 0, 0, 0, 0, 0, 0, 0, 1}});
  REQUIRE(of_unity.size() == 1);
  CHECK(of_unity[0].argument == Bivariate({{0, 8}, {1}}));
}

TEST_CASE("Lazard–Rioboo–Trager: law: arguments of two and three poles, too, with many digits") {
  for_samples(12, [](Random& random) {
    const Polynomial base = squarefree_part(random.nonconstant_polynomial(6));
    const Polynomial inner = Polynomial::monomial(1, random.integer(2, 3)) + random.polynomial(1);
    const Polynomial d = compose(base, inner);
    if (!is_squarefree(d)) return;
    const RationalFunction f(compose(random.polynomial(5) % base, inner) * differentiate(inner), d);
    RationalFunction derivative;
    for (const LogSum& sum : lazard_rioboo_trager(f)) {
      // Of the monic argument, with its long coefficients, in another variable than the residue.
      const Polynomial half{0, Rational(1, 2)};
      std::vector<Polynomial> rows;
      const Bivariate monic = made_monic(sum.argument, sum.index);
      for (const Polynomial& c : monic.coefficients()) rows.push_back(compose(c, half));
      derivative =
          derivative + differentiate(LogSum{compose(sum.index, half), half, Bivariate(rows)});
    }
    CHECK(derivative == f);
  });
}
