#include "phrame/integrate/absolute_integral.hpp"

#include <doctest/doctest.h>

#include "phrame/algebra/error.hpp"
#include "phrame/algebra/rounding.hpp"
#include "support/random.hpp"

using namespace phrame;

TEST_CASE("absolute integral: |2t - 1|, exactly") {
  const AbsoluteIntegral size({Polynomial{-1, 2}});
  REQUIRE(size.sign_changes().size() == 1);
  CHECK(size.sign_changes()[0] == RealAlgebraic(Rational(1, 2)));
  CHECK(size.value(Rational(1)).exact() == Rational(1, 2));
  CHECK(size.value(Rational(3, 4)).exact() == Rational(5, 16));  // 1/4 + 1/16
  CHECK(size.value(Rational(1, 4)).exact() == Rational(3, 16));
  CHECK(size.value(Rational(0)).exact() == Rational(0));
  CHECK(size.integral().value(Rational(1)).exact() == Rational(0));
  CHECK_THROWS_AS(size.value(Rational(2)), DomainError);
}

TEST_CASE("absolute integral: a sign that changes at an irrational place") {
  // ∫₀¹ |t² − 1/2| = √2/3 − 1/6.
  const AbsoluteIntegral size({Polynomial{Rational(-1, 2), 0, 1}});
  const long bits = 200;
  const RealBall value = size.enclose(Rational(1), bits);
  const RealBall known = subtract(divide(sqrt(RealBall(2, 300), 300), RealBall(3, 300), 300),
                                  RealBall(Rational(1, 6), 300), 300);
  CHECK(value.overlaps(known));
  CHECK(value.is_accurate(bits - 10));
  CHECK(round_to_decimal(size.value(Rational(1)), 20).value == "0.30473785412436501627");
  // At a place that is only known by balls, even the one where the sign changes: ∫₀^(1/√2) is √2/6.
  const Real change([](long b) { return sqrt(RealBall(Rational(1, 2), b), b); });
  CHECK(size.enclose(change, bits)
            .overlaps(divide(sqrt(RealBall(2, 300), 300), RealBall(6, 300), 300)));
  CHECK(size.enclose(change, bits).is_accurate(bits - 10));
}

// f = x/√(x² + ε²), x = t − 1/2, is nearly −1 before 1/2 and 1 behind it: ∫₀ᵗ |f| is √(1/4 + ε²) −
// ε ± (√(x² + ε²) − ε). The ball [49/100, 69/100] is around 59/100, where a sum without the change
// at 1/2 is off by twice 9/100, more than f is large along the radius.
TEST_CASE("absolute integral: a ball of t on both sides of a change holds the values of both") {
  const long bits = 64;
  const Rational epsilon(1, 1000);
  const Rational squared = epsilon * epsilon;
  const AbsoluteIntegral size(
      RootQuotient{{Rational(-1, 2), 1}, {1}, {Rational(1, 4) + squared, -1, 1}});
  const Real near([](long) { return hull(Rational(49, 100), Rational(69, 100), 64); });
  const RealBall value = size.enclose(near, bits);
  for (const Rational& t : {Rational(49, 100), Rational(1, 2), Rational(3, 5), Rational(69, 100)}) {
    const Rational x = t - Rational(1, 2);
    const auto root = [&](const Rational& y) { return sqrt(RealBall(y * y + squared, 128), 128); };
    const RealBall part = subtract(root(x), RealBall(epsilon, 128), 128);
    const RealBall whole = subtract(root(Rational(1, 2)), RealBall(epsilon, 128), 128);
    CHECK(value.overlaps(x < 0 ? subtract(whole, part, 128) : add(whole, part, 128)));
  }
}

TEST_CASE("absolute integral: no change where N has a double zero, and 0 of 0") {
  const AbsoluteIntegral square({Polynomial{1, -4, 4}});  // (2t − 1)²
  CHECK(square.sign_changes().empty());
  CHECK(square.value(Rational(1)).exact() == Rational(1, 3));
  CHECK(AbsoluteIntegral({Polynomial{}}).value(Rational(1)).exact() == Rational(0));
  const AbsoluteIntegral negative({Polynomial{-1}});
  CHECK(negative.value(Rational(1, 3)).exact() == Rational(1, 3));
}

TEST_CASE("absolute integral: law: a sum over the parts of one sign") {
  test::for_samples(20, [](test::Random& random) {
    // N with the known changes a < b in (0, 1), over 1 + t².
    const Rational a(random.integer(1, 40), 100);
    const Rational b(random.integer(50, 99), 100);
    const Polynomial N = random.integer(1, 5) * Polynomial{-a, 1} * Polynomial{-b, 1};
    const RootQuotient f{N, {1, 0, 1}, {1}};
    const AbsoluteIntegral size(f);
    CHECK(size.sign_changes().size() == 2);
    const TaylorIntegral F(f);
    const auto between = [&](const Rational& from, const Rational& to) {
      return subtract(F.enclose(to, 120), F.enclose(from, 120), 120);
    };
    const RealBall sum = add(subtract(between(0, a), between(a, b), 120), between(b, 1), 120);
    CHECK(size.enclose(Rational(1), 100).overlaps(sum));
    CHECK(size.enclose(Rational(1), 100).is_accurate(85));
  });
}
