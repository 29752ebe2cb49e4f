#include "phrame/integrate/log_argument.hpp"

#include "support/random.hpp"

using namespace phrame;

TEST_CASE("argument of a logarithm: over a field of degree ≤ 2 it is monic") {
  // (2x + 1)·t + 3 over x² − 2: 1/(2x + 1) = (2x − 1)/7.
  const Bivariate v({Polynomial{3}, Polynomial{1, 2}});
  CHECK(short_argument(v, {-2, 0, 1}) ==
        Bivariate({Polynomial{Rational(-3, 7), Rational(6, 7)}, Polynomial{1}}));
  const Rational large{Integer("123456789012345678901234567890123456789")};
  const Polynomial lead{1, large};  // 1/(1 + lx) = (1 − lx)/(1 − 2l²)
  const Rational norm = 1 - 2 * large * large;
  CHECK(short_argument(Bivariate({Polynomial{3}, lead}), {-2, 0, 1}) ==
        Bivariate({Polynomial{3 / norm, -3 * large / norm}, Polynomial{1}}));
  CHECK(short_argument(v, {-5, 1}) == Bivariate({Polynomial{Rational(3, 11)}, Polynomial{1}}));
}

TEST_CASE("argument of a logarithm: monic where that is short, else primitive, never both") {
  const Polynomial q{3, 1, 0, 0, 0, 7};
  const Polynomial slope = differentiate(q);
  const QuotientRing ring(q);
  const Bivariate monic({Polynomial{5, -1, Rational(2, 3)}, Polynomial{0, 4}, Polynomial{1}});
  std::vector<Polynomial> rows;
  for (const Polynomial& c : monic.coefficients()) rows.push_back(ring.multiply(c, slope));
  CHECK(short_argument(Bivariate(rows), q) == monic);

  const Bivariate long_if_monic({Polynomial{12345678, 87654321}, Rational(2) * slope});
  const Bivariate found = short_argument(long_if_monic, q);
  CHECK(found == primitive_part(long_if_monic));
}

TEST_CASE("argument of a logarithm: of h(t): as composed, and taken apart again") {
  const Polynomial h{0, 3, Rational(1, 2), 1};
  const Polynomial lead{5, 0, 7};
  const Bivariate w({Polynomial{1, 2, 3}, lead});
  const Bivariate v = composed(w, h);
  CHECK(v == primitive_part(
                 Bivariate({w.coefficient(0), Rational(3) * lead, Rational(1, 2) * lead, lead})));
  const auto found = as_composed(v);
  REQUIRE(found);
  CHECK(found->inner == h);
  CHECK(primitive_part(found->outer) == w);
  CHECK(composed(Bivariate({Polynomial{0, 2}, Polynomial{1}}), h) ==
        Bivariate({Polynomial{0, 2}, Polynomial{3}, Polynomial{Rational(1, 2)}, Polynomial{1}}));
  CHECK_FALSE(as_composed(w));
  // x·t depends on the residue in another way than the leading coefficient.
  CHECK_FALSE(as_composed(Bivariate({Polynomial{1}, Polynomial{0, 1}, Polynomial{1}})));
  // w² is of degree 2 in h.
  CHECK_FALSE(
      as_composed(composed(Bivariate({Polynomial{1}, Polynomial{0, 1}, Polynomial{1}}), h)));
}
