#include "phrame/integrate/antiderivative.hpp"

#include <type_traits>

#include "support/random.hpp"

using namespace phrame;
using test::for_samples;
using test::Random;

static_assert(std::is_nothrow_move_constructible_v<Antiderivative>);

TEST_CASE(
    "antiderivative: Σ x log(t + 2x) over 4x² + 1 = 0 is arctan: its derivative is 1/(t² + 1)") {
  const LogSum arctan{{1, 0, 4}, {0, 1}, Bivariate({Polynomial{0, 2}, Polynomial{1}})};
  CHECK_FALSE(is_over_poles(arctan));
  CHECK(differentiate(arctan) == RationalFunction({1}, {1, 0, 1}));
}

TEST_CASE("antiderivative: the derivative of log t over the pole 0") {
  const LogSum log{{0, 1}, {1}, Bivariate({Polynomial{}, Polynomial{1}})};
  CHECK(is_over_poles(log));
  CHECK(differentiate(log) == RationalFunction({1}, {0, 1}));
}

TEST_CASE("antiderivative: polynomial, rational and logarithmic parts add up") {
  const Antiderivative F{{0, 0, 1},
                         RationalFunction({1}, {0, 1}),
                         {{{1, 0, 4}, {0, 1}, Bivariate({Polynomial{0, 2}, Polynomial{1}})}}};
  const RationalFunction expected = RationalFunction({0, 2}) - RationalFunction({1}, {0, 0, 1}) +
                                    RationalFunction({1}, {1, 0, 1});
  CHECK(differentiate(F) == expected);
  CHECK(differentiate(Antiderivative{}) == RationalFunction());
}

TEST_CASE("antiderivative: law: with rational indices the derivative is Σ c·v′/v, term by term") {
  for_samples(80, [](Random& random) {
    // q with known rational roots α: every term can be differentiated by itself.
    Polynomial q{1};
    std::vector<Rational> alphas;
    for (long k = random.integer(1, 3); k > 0; --k) {
      const Rational alpha = random.integer(-9, 9);
      if (q(alpha) == 0) continue;
      alphas.push_back(alpha);
      q *= Polynomial{-alpha, 1};
    }
    const QuotientRing ring(q);
    const Polynomial c = ring.reduce(random.polynomial(3));
    std::vector<Polynomial> v;
    for (long k = random.integer(1, 3); k > 0; --k) v.push_back(ring.reduce(random.polynomial(2)));
    v.push_back(Polynomial{1});
    RationalFunction expected;
    for (const Rational& alpha : alphas) {
      std::vector<Rational> at;
      for (const Polynomial& coefficient : v) at.push_back(coefficient(alpha));
      const Polynomial argument(at);
      expected = expected + RationalFunction(c(alpha) * differentiate(argument), argument);
    }
    CHECK(differentiate(LogSum{q, c, Bivariate(v)}) == expected);
  });
}
