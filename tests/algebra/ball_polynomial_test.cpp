#include <algorithm>

#include "phrame/algebra/ball_polynomial.hpp"

#include "phrame/algebra/sturm.hpp"
#include "support/random.hpp"

namespace ball_polynomial_test {

using namespace phrame;
using test::for_samples;
using test::Random;

namespace {

constexpr long bits = 160;

/// Does every ball contain the coefficient of p?
bool contains(const BallPolynomial& set, const Polynomial& p) {
  for (long k = 0; k <= std::max(set.degree_bound(), p.degree()); ++k)
    if (!set.coefficient(k).contains(p.coefficient(k))) return false;
  return true;
}

}  // namespace

TEST_CASE("ball polynomial: law: contains what exact arithmetic gives") {
  for_samples(200, [](Random& random) {
    const Polynomial p = random.polynomial(6);
    const Polynomial q = random.polynomial(5);
    const BallPolynomial a(p, 60);
    const BallPolynomial b(q, 60);
    CHECK(contains(add(a, b, 60), p + q));
    CHECK(contains(subtract(a, b, 60), p - q));
    CHECK(contains(multiply(a, b, 60), p * q));
    CHECK(contains(differentiate(a, 60), differentiate(p)));
    const Rational t = random.rational();
    CHECK(contains(multiply(RealBall(t, 60), a, 60), t * p));
    CHECK(evaluate(a, RealBall(t, 60), 60).contains(p(t)));
  });
}

TEST_CASE("ball polynomial: law: Bernstein coefficients, and parts of [0, 1]") {
  for_samples(200, [](Random& random) {
    const Polynomial p = random.nonzero_polynomial(6);
    const auto b = to_bernstein(BallPolynomial(p, bits), p.degree(), bits);
    const auto exact = to_bernstein(p, p.degree());
    REQUIRE(b.size() == exact.size());
    for (std::size_t k = 0; k < b.size(); ++k) CHECK(b[k].contains(exact[k]));
    CHECK(contains(from_bernstein(b, bits), p));
    const Rational share(random.integer(1, 9), 10);
    const auto [left, right] = split(b, share, bits);
    const auto part = [&](const Rational& from, const Rational& to) {
      return compose(p, Polynomial{from, to - from});
    };
    CHECK(contains(from_bernstein(left, bits), part(0, share)));
    CHECK(contains(from_bernstein(right, bits), part(share, 1)));
  });
}

// Against Sturm's theorem.
TEST_CASE("ball polynomial: law: sign changes") {
  for_samples(300, [](Random& random) {
    Polynomial p{1};
    for (long k = random.integer(0, 4); k > 0; --k) p *= random.nonconstant_polynomial(2);
    Polynomial odd{1};  // the zeros of odd order in (0, 1), each once
    for (const Interval& zero : isolate_real_roots(p, open_interval(0, 1))) {
      long order = 0;
      for (Polynomial d = p; count_real_roots(gcd(d, p), zero) == 1; d = differentiate(d)) {
        ++order;
        if (order > p.degree()) break;
      }
      if (order % 2 == 0) odd = {};  // not decided by balls
    }
    const SignChanges found = sign_changes(BallPolynomial(p, 400), 60);
    const long expected = odd.is_zero() ? -1 : count_real_roots(p, open_interval(0, 1));
    if (found.is_complete() && expected >= 0 && is_squarefree(p))
      CHECK(static_cast<long>(found.at.size()) == expected);
    for (const RealBall& at : found.at) {
      CHECK(at.radius() <= Rational(1, Integer(1) << 60U));
      CHECK(p(at.lower()) * p(at.upper()) < 0);
    }
    // A squarefree polynomial without zeros at the ends is decided.
    if (is_squarefree(p) && p(0) != 0 && p(1) != 0) CHECK(found.is_complete());
  });
}

TEST_CASE("ball polynomial: what balls cannot decide is said") {
  // A double zero, a zero at an end, and 0 itself.
  CHECK_FALSE(sign_changes(BallPolynomial(Polynomial{1, -4, 4}, bits), 60).is_complete());
  CHECK_FALSE(sign_changes(BallPolynomial(Polynomial{0, 1}, bits), 60).is_complete());
  const BallPolynomial nearly_zero({RealBall(Rational(1, 3), 30), RealBall(Rational(1, 7), 30)});
  CHECK_FALSE(sign_changes(subtract(nearly_zero, nearly_zero, bits), 60).is_complete());
  CHECK(sign_changes(BallPolynomial(), 60).is_complete());
  // Where a part is halved, and next to an end.
  const SignChanges half = sign_changes(BallPolynomial(Polynomial{-1, 2}, bits), 60);
  CHECK(half.is_complete());
  REQUIRE(half.at.size() == 1);
  CHECK(half.at[0].contains(Rational(1, 2)));
  const Polynomial dense = Polynomial{-1, 2} * Polynomial{-1, 4} * Polynomial{-3, 4};
  const SignChanges three = sign_changes(BallPolynomial(dense, bits), 60);
  CHECK(three.is_complete());
  CHECK(three.at.size() == 3);
}

TEST_CASE("ball polynomial: law: negatives, integrals, shifts and stretches") {
  for_samples(200, [](Random& random) {
    const Polynomial p = random.polynomial(7);
    const BallPolynomial a(p, 100);
    CHECK(contains(-a, -p));
    CHECK(contains(antiderivative(a, 100), antiderivative(p)));
    const Rational c = random.rational();
    CHECK(contains(shifted(a, RealBall(c, 100), 100), compose(p, {c, 1})));
    CHECK(contains(stretched(a, 3), compose(p, {0, 8})));
    CHECK(contains(stretched(a, -2), compose(p, {0, Rational(1, 4)})));
    CHECK(contains(with_constant(a, RealBall(c, 100)), p + Polynomial{c - p.coefficient(0)}));
  });
}

}  // namespace ball_polynomial_test
