#include "phrame/integrate/residue_derivative.hpp"

#include "phrame/integrate/lazard_rioboo_trager.hpp"
#include "support/random.hpp"

namespace residue_derivative_test {

using namespace phrame;
using test::for_samples;
using test::Random;

namespace {

/// The same sum with another residue than x: c = x/3 over the roots 3α.
LogSum with_other_index(const LogSum& sum) {
  const Polynomial third{0, Rational(1, 3)};
  std::vector<Polynomial> rows;
  for (const Polynomial& c : sum.argument.coefficients()) rows.push_back(compose(c, third));
  return {compose(sum.index, third), third, Bivariate(rows)};
}

}  // namespace

TEST_CASE("derivative over residues: law: it is that by power sums over ℚ, and the fraction") {
  for_samples(40, [](Random& random) {
    const Polynomial base = squarefree_part(random.nonconstant_polynomial(4));
    const Polynomial inner = Polynomial::monomial(1, random.integer(1, 3)) + Polynomial{0, 2};
    const Polynomial d = compose(base, inner);
    if (!is_squarefree(d)) return;
    const RationalFunction f(compose(random.polynomial(3) % base, inner) * differentiate(inner), d);
    RationalFunction total;
    for (const LogSum& sum : lazard_rioboo_trager(f)) {
      const auto found = derivative_over_residues(sum);
      REQUIRE(found.has_value() == (sum.residue == Polynomial{0, 1}));
      const RationalFunction expected = differentiate(with_other_index(sum));
      if (found) CHECK(*found == expected);
      total = total + expected;
    }
    CHECK(total == f);
  });
}

TEST_CASE("derivative over residues: none where a zero belongs to two residues, or twice to one") {
  const Polynomial q{-6, 11, -6, 1};  // 1, 2, 3
  const Polynomial x{0, 1};
  const Bivariate t({Polynomial{}, Polynomial{1}});
  CHECK_FALSE(derivative_over_residues({q, x, t}));
  CHECK(differentiate(LogSum{q, x, t}) == RationalFunction({6}, {0, 1}));
  // (t − x)².
  const Bivariate square({Polynomial{0, 0, 1}, Polynomial{0, -2}, Polynomial{1}});
  CHECK_FALSE(derivative_over_residues({q, x, square}));
  CHECK(differentiate(LogSum{q, x, square}) == RationalFunction({2}, {-1, 1}) +
                                                   RationalFunction({4}, {-2, 1}) +
                                                   RationalFunction({6}, {-3, 1}));
  // Another residue than x.
  CHECK_FALSE(derivative_over_residues({q, {1, 1}, Bivariate({Polynomial{0, -1}, Polynomial{1}})}));
  // A leading coefficient that is 0 at a root of the index.
  CHECK_FALSE(derivative_over_residues({q, x, Bivariate({Polynomial{1}, Polynomial{-1, 1}})}));
}

TEST_CASE("derivative over residues: a leading coefficient that depends on the residue is none") {
  // Σ α·log((α² + 1)·(t − 5α)) = Σ α·log(t − 5α) over 1, 2, 3, 4.
  const Polynomial q{24, -50, 35, -10, 1};
  const LogSum sum{
      q,
      {0, 1},
      QuotientRing(q).reduce(Bivariate({Polynomial{0, -5, 0, -5}, Polynomial{1, 0, 1}}))};
  RationalFunction expected;
  for (long k = 1; k <= 4; ++k) expected = expected + RationalFunction({k}, {-5 * k, 1});
  CHECK(derivative_over_residues(sum) == expected);
  CHECK(differentiate(with_other_index(sum)) == expected);
}

}  // namespace residue_derivative_test
