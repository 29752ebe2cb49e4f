#include "phrame/algebra/rational_function.hpp"

#include <type_traits>

#include "phrame/algebra/error.hpp"
#include "support/random.hpp"

using namespace phrame;
using test::for_samples;
using test::Random;

static_assert(std::is_nothrow_move_constructible_v<RationalFunction>);

TEST_CASE("rational function: lowest terms have a primitive denominator with positive lead") {
  const RationalFunction f({-2, 0, 2}, {Rational(-3), Rational(-3)});  // 2(t²−1)/(−3(t+1))
  CHECK(f.numerator() == Polynomial{Rational(2, 3), Rational(-2, 3)});
  CHECK(f.denominator() == Polynomial{1});
  CHECK(f.is_polynomial());
  CHECK_FALSE(f.is_proper());
  CHECK(RationalFunction({}, {5, 5}) == RationalFunction());
  CHECK(RationalFunction().is_proper());
  CHECK_THROWS_AS(RationalFunction({1}, {}), DomainError);
}

TEST_CASE("rational function: a moved-from one is 0/1") {
  RationalFunction f({1}, {1, 1});
  const RationalFunction g = std::move(f);
  CHECK(f == RationalFunction());  // NOLINT(bugprone-use-after-move): the promise under test
  CHECK(f.denominator() == Polynomial{1});
  CHECK_FALSE(g.is_zero());
}

TEST_CASE("rational function: law: values, derivative, lowest terms") {
  for_samples(100, [](Random& random) {
    const Polynomial a = random.nonzero_polynomial(3);
    const Polynomial b = random.nonzero_polynomial(3);
    const RationalFunction f(random.polynomial(3), a);
    const RationalFunction g(random.polynomial(3), b);
    CHECK(gcd(f.numerator(), f.denominator()).is_constant());
    CHECK(RationalFunction(f.numerator() * b, f.denominator() * b) == f);
    CHECK(differentiate(f * g) == differentiate(f) * g + f * differentiate(g));
    CHECK(f + g - g == f);
    const Rational t = random.rational();
    if (a(t) == 0 || b(t) == 0) return;
    CHECK((f + g)(t) == f(t) + g(t));
    CHECK((f * g)(t) == f(t) * g(t));
    CHECK((-f)(t) == -f(t));
  });
}

TEST_CASE("rational function: the value at a pole is refused by name") {
  CHECK_THROWS_WITH_AS(RationalFunction({1}, {-1, 3})(Rational(1, 3)),
                       doctest::Contains("pole at t = 1/3"), DomainError);
}

TEST_CASE("rational function: law: a composition has the values of its parts") {
  for_samples(100, [](Random& random) {
    const RationalFunction f(random.polynomial(3), random.nonzero_polynomial(3));
    const RationalFunction g(random.polynomial(3), random.nonzero_polynomial(3));
    const Polynomial p = random.polynomial(3);
    const Rational t = random.rational();
    const auto has_value = [](const RationalFunction& function, const Rational& at) {
      return function.denominator()(at) != 0;
    };
    if (has_value(f, p(t))) CHECK(compose(f, p)(t) == f(p(t)));
    if (!has_value(g, t)) return;
    if (has_value(f, g(t)))
      CHECK(compose(f, g)(t) == f(g(t)));
    else if (constant(g))
      CHECK_THROWS_AS(compose(f, g), DomainError);
    else
      CHECK_FALSE(has_value(compose(f, g), t));
  });
}

TEST_CASE("rational function: a constant has its value, others have none") {
  CHECK(constant(RationalFunction()) == Rational(0));
  CHECK(constant(RationalFunction({2, 4}, {3, 6})) == Rational(2, 3));
  CHECK_FALSE(constant(RationalFunction({0, 1}, {1})).has_value());
  CHECK_FALSE(constant(RationalFunction({1}, {0, 1})).has_value());
  CHECK_THROWS_AS(compose(RationalFunction({1}, {0, 1}), RationalFunction()), DomainError);
}
