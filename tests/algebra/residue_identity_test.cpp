#include "phrame/algebra/residue_identity.hpp"

#include "phrame/algebra/modular.hpp"
#include "phrame/algebra/resultant.hpp"
#include "support/random.hpp"

namespace residue_identity_test {

using namespace phrame;
using test::for_samples;
using test::Random;

TEST_CASE(
    "residue identity: 1/(t² + 1) has the residues c = −z/2, so that z + 2c = 0 at its poles") {
  const Polynomial one{1};
  const Polynomial d{1, 0, 1};
  const Bivariate t_plus_2x({Polynomial{0, 2}, one});
  const Bivariate t_minus_2x({Polynomial{0, -2}, one});
  CHECK(vanish_at_residues({t_plus_2x}, one, d));
  CHECK_FALSE(vanish_at_residues({t_minus_2x}, one, d));
  CHECK_FALSE(vanish_at_residues({t_plus_2x, t_minus_2x}, one, d));
  CHECK(vanish_at_residues({}, one, d));
  CHECK(vanish_at_residues({Bivariate()}, one, d));
}

TEST_CASE(
    "residue identity: law: the residue polynomial is 0 at the residues, another one is not") {
  for_samples(40, [](Random& random) {
    const Polynomial d =
        squarefree_part(random.nonconstant_polynomial(4) * random.nonconstant_polynomial(2));
    const Polynomial n = random.polynomial(5) % d;
    if (n.is_zero()) return;
    const Polynomial residues = residue_polynomial(n, d);
    CHECK(vanish_at_residues({Bivariate({residues})}, n, d));
    CHECK_FALSE(vanish_at_residues({Bivariate({residues + Polynomial{1}})}, n, d));
    // Multiples of d, in t.
    std::vector<Polynomial> rows;
    for (const Rational& c : (d * Polynomial{2, 3}).coefficients()) rows.push_back({c, 5 * c});
    CHECK(vanish_at_residues({Bivariate(rows)}, n, d));
  });
}

TEST_CASE("residue identity: what is 0 modulo the first primes is not taken for 0") {
  // The residues of 1/(t(t − 1)) are −1 and 1: there x² − 1 is 0, and x + 1 is not 0 at one.
  Primes primes;
  Integer product = 1;
  for (int k = 0; k < 3; ++k) product *= Integer(primes.next());
  const Polynomial vanishing{-1, 0, 1};
  CHECK(vanish_at_residues({Bivariate({vanishing})}, {1}, {0, -1, 1}));
  const Bivariate v({vanishing + Rational(product) * Polynomial{1, 1}});
  CHECK_FALSE(vanish_at_residues({v}, {1}, {0, -1, 1}));
  // 1/(t² − 2) has the residues ±√2/4, at t = ±√2: 8x² − 1 and 4x − t are 0, 4x + t is not.
  const Polynomial quadratic{-1, 0, 8};
  const Bivariate w(
      {quadratic + Rational(product) * Polynomial{0, 4}, -Rational(product) * Polynomial{1}});
  CHECK(vanish_at_residues({Bivariate({{0, 4}, {-1}})}, {1}, {-2, 0, 1}));
  CHECK(vanish_at_residues({w}, {1}, {-2, 0, 1}));
  const Bivariate wrong(
      {quadratic + Rational(product) * Polynomial{0, 4}, Rational(product) * Polynomial{1}});
  CHECK_FALSE(vanish_at_residues({wrong}, {1}, {-2, 0, 1}));
}

}  // namespace residue_identity_test
