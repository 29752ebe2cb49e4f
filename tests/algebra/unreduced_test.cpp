#include "phrame/algebra/unreduced.hpp"

#include <array>
#include <cmath>

#include "phrame/algebra/error.hpp"
#include "support/random.hpp"

using namespace phrame;
using test::for_samples;
using test::Random;

namespace {

const SizeLimits usual;

RationalFunction rational_function(Random& random) {
  switch (random.integer(0, 3)) {
    case 0:
      return RationalFunction(Polynomial::monomial(random.rational(), random.integer(0, 4)));
    case 1:
      return {random.polynomial(0), Polynomial::monomial(1, random.integer(0, 4))};
    case 2:
      return RationalFunction(random.repeated_polynomial(2));
    default:
      return {random.repeated_polynomial(2), random.repeated_polynomial(2)};
  }
}

RationalFunction inverse(const RationalFunction& f) { return {f.denominator(), f.numerator()}; }

}  // namespace

TEST_CASE("unreduced: law: products, quotients and powers are those of rational functions") {
  for_samples(200, [](Random& random) {
    RationalFunction expected = rational_function(random);
    Unreduced value(expected);
    for (int step = 0; step < 4; ++step) {
      const RationalFunction f = rational_function(random);
      if (random.chance(2) && !f.is_zero()) {
        value.divide(Unreduced(f), usual);
        expected = expected * inverse(f);
      } else {
        value.multiply(Unreduced(f), usual);
        expected = expected * f;
      }
    }
    CHECK(value.reduced(usual) == expected);
    CHECK(value.is_zero() == expected.is_zero());
    CHECK(value.constant().has_value() ==
          (expected.is_polynomial() && expected.numerator().is_constant()));
    const long exponent = expected.is_zero() ? 2 : random.integer(-3, 3);
    RationalFunction power(Polynomial{1});
    for (long k = 0; k < std::abs(exponent); ++k)
      power = power * (exponent < 0 ? inverse(expected) : expected);
    value.raise(exponent, usual);
    CHECK(value.reduced(usual) == power);
    value.negate();
    CHECK(value.reduced(usual) == -power);
  });
}

TEST_CASE("unreduced: law: a sum is that of rational functions, in any order") {
  for_samples(200, [](Random& random) {
    RationalFunction expected = rational_function(random);
    std::vector<RationalFunction> terms{expected};
    UnreducedSum sum(Unreduced(expected), usual);
    for (long k = random.integer(0, 8); k > 0; --k) {
      // Sometimes everything cancels.
      const RationalFunction f = random.chance(6) ? -expected : rational_function(random);
      sum.add(Unreduced(f));
      terms.push_back(f);
      expected = expected + f;
    }
    CHECK(sum.total().reduced(usual) == expected);
    CHECK(sum.total().is_zero() == expected.is_zero());
    UnreducedSum backwards(Unreduced(terms.back()), usual);
    for (std::size_t k = terms.size() - 1; k-- > 0;) backwards.add(Unreduced(terms[k]));
    CHECK(backwards.total().reduced(usual) == expected);
  });
}

TEST_CASE("unreduced: what cancels does not count against the limits") {
  const RationalFunction linear(Polynomial{1, 1});
  Unreduced value(linear);
  for (int k = 0; k < 100; ++k) {
    value.multiply(Unreduced(linear), {10});
    value.divide(Unreduced(linear), {10});
  }
  CHECK(value.reduced({10}) == linear);
  Unreduced one(RationalFunction(Polynomial{1, 1}));
  one.divide(Unreduced(linear), {10});
  one.raise(Integer("1000000000000000000000000"), {10});
  CHECK(one.constant() == Rational(1));
}

TEST_CASE("unreduced: degrees and numbers beyond the limits are Undecided, without the work") {
  const Integer huge("1000000000000000000000000");
  const RationalFunction linear(Polynomial{1, 1});
  for (const Unreduced& start : {Unreduced(2), Unreduced(Rational(1, 3)), Unreduced(linear),
                                 Unreduced::monomial(1, 1), Unreduced::monomial(1, -1)}) {
    Unreduced up = start;
    CHECK_THROWS_AS(up.raise(huge, usual), Undecided);
    Unreduced down = start;
    CHECK_THROWS_AS(down.raise(-huge, usual), Undecided);
  }
  Unreduced sixth(linear);
  sixth.raise(6, {10});
  Unreduced product = sixth;
  CHECK_THROWS_AS(product.multiply(sixth, {10}), Undecided);
  UnreducedSum wide(Unreduced::monomial(1, 6), {10});
  wide.add(Unreduced::monomial(1, -6));
  CHECK_THROWS_AS(wide.total(), Undecided);
  Unreduced number(Rational(1, 30));
  CHECK_THROWS_AS(number.multiply(Unreduced(Rational(1, 31)), {10, 8}), Undecided);
}

TEST_CASE("unreduced: -1 may have any exponent, 0 none that is not positive") {
  const Integer odd("1000000000000000000000001");
  Unreduced minus_one(-1);
  minus_one.raise(odd, usual);
  CHECK(minus_one.constant() == Rational(-1));
  minus_one.raise(-odd - 1, usual);
  CHECK(minus_one.constant() == Rational(1));
  Unreduced zero;
  zero.raise(odd, usual);
  CHECK(zero.is_zero());
  CHECK_THROWS_AS(zero.raise(0, usual), DomainError);
  CHECK_THROWS_AS(zero.raise(-1, usual), DomainError);
  CHECK_THROWS_AS(minus_one.divide(zero, usual), DomainError);
}
