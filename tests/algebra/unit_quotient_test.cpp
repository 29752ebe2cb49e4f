#include "phrame/algebra/unit_quotient.hpp"

#include <doctest/doctest.h>

#include <cmath>

#include "phrame/algebra/rounding.hpp"
#include "support/random.hpp"

using namespace phrame;

namespace {

/// c²·N²/(D²·S) at x, exactly, with the sign of the function.
Rational signed_square(const UnitQuotient& f, const Rational& x) {
  const auto at = [&x](const IntegerPolynomial& p) { return to_polynomial(p.get())(x); };
  const Rational top = f.factor * at(f.numerator) / at(f.denominator);
  return Rational(top.sign()) * top * top / at(f.radicand);
}

Polynomial positive(test::Random& random, long factors) {
  Polynomial product{Rational(random.integer(1, 9), random.integer(1, 9))};
  for (long k = 0; k < factors; ++k) {
    const Rational re(random.integer(-8, 8), 3);
    const Rational im(random.integer(1, 20), random.integer(1, 10));
    product *= Polynomial{re * re + im * im, -2 * re, 1};
  }
  return product;
}

}  // namespace

TEST_CASE("unit quotient: the same function over the integers, and on halves") {
  test::Random random(71);
  for (long k = 0; k < 10 * test::multiplier(); ++k) {
    const Polynomial N = random.nonzero_polynomial(5);
    const Polynomial D = positive(random, random.integer(0, 2));
    const Polynomial S = k % 2 == 0 ? positive(random, 2) : Polynomial{Rational(7, 3), 1, 0, 1};
    const UnitQuotient f = unit_quotient(N, D, S);
    for (const Rational& x : {Rational(-1), Rational(-1, 3), Rational(1, 2), Rational(1)}) {
      const Rational top = N(x) / D(x);
      CHECK(signed_square(f, x) == Rational(top.sign()) * top * top / S(x));
      for (const long side : {-1, 1})
        CHECK(signed_square(half_of(f, side), x) ==
              signed_square(f, Rational((x + Rational(side)) / 2)));
    }
    // f(0) = unit_factor(f)·N(0)/2ᵉ.
    const Rational nu =
        Rational(f.numerator.get()->length == 0 ? Rational(0)
                                                : to_polynomial(f.numerator.get()).coefficient(0)) *
        power_of_two(-unit_exponent(f.numerator));
    const RealBall at_0 = multiply(unit_factor(f, 100), RealBall(nu, 100), 100);
    const Rational square = signed_square(f, 0);
    CHECK(multiply(absolute(at_0), at_0, 100).contains(square));
    CHECK((square == 0 || at_0.accuracy_bits() > 90));
  }
}

TEST_CASE("unit quotient: bounds hold, also where a root is near") {
  test::Random random(72);
  long decided = 0;
  for (long k = 0; k < 40 * test::multiplier(); ++k) {
    const Polynomial D = positive(random, random.integer(0, 2));
    const Polynomial S = positive(random, random.integer(0, 3));
    const auto bounds = unit_bounds(unit_quotient({1}, D, S));
    if (!bounds) continue;
    ++decided;
    for (long x = -8; x <= 8; ++x) {
      const Rational sigma = S(Rational(x, 8)) / S(0);
      const Rational delta = D(Rational(x, 8)) / D(0);
      CHECK(static_cast<double>(sigma) * bounds->root * bounds->root >= 1);
      CHECK(static_cast<double>(delta) * bounds->quotient >= 1);
    }
  }
  CHECK(decided > 5);
}

TEST_CASE("unit quotient: no bounds where there is a zero, or nearly") {
  CHECK_FALSE(unit_bounds(unit_quotient({1}, {Rational(-1, 2), 1}, {1})));
  CHECK_FALSE(unit_bounds(unit_quotient({1}, {1}, {Rational(99, 100), 1})));
  CHECK_FALSE(unit_bounds(unit_quotient({1}, {1}, {power_of_ten(-30), 0, 1})));
  CHECK_FALSE(unit_bounds(unit_quotient({1}, {power_of_ten(-400), 0, 1}, {1})));
  CHECK(unit_bounds(unit_quotient({1}, {3, 1}, {5, 0, 1})));
  // 1/(1 + x²/4) has the coefficients (±1/4)ᵏ: one bit a term.
  CHECK(unit_bounds(unit_quotient({1}, {4, 0, 1}, {1}))->bits_per_term ==
        doctest::Approx(1).epsilon(0.1));
  // |ν| is between 1/4 and 1 for one coefficient; σ and δ are 1.
  const UnitBounds one = *unit_bounds(unit_quotient({1}, {1}, {1}));
  CHECK(one.root >= 1);
  CHECK(one.quotient >= 1);
  CHECK(one.mean_size <= 1);
  CHECK(one.mean_size >= 0.2);
}
