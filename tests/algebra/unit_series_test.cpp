#include "phrame/algebra/unit_series.hpp"

#include <doctest/doctest.h>

#include "phrame/algebra/rounding.hpp"
#include "support/random.hpp"

using namespace phrame;

namespace {

/// ∫ from −1 to x of N/(D√S).
RealBall integral(const UnitQuotient& f, const Rational& x, long bits) {
  const auto series = unit_series(f, *unit_bounds(f), bits);
  REQUIRE(series);
  const RealBall sum = subtract(evaluate(series->integral(), RealBall(x, bits + 64), bits + 64),
                                series->start, bits + 64);
  return multiply(unit_factor(f, bits + 64), widened(sum, series->error), bits + 64);
}

}  // namespace

TEST_CASE("unit series: known integrals") {
  // mpmath: 2*asinh(1/sqrt(5)), 2*atan(1/3)/3, and quad of the third to 1/4 and to 1.
  CHECK(to_string(integral(unit_quotient({1}, {1}, {5, 0, 1}), 1, 120), 30) ==
        "0.867014726490565103950520269501");
  CHECK(to_string(integral(unit_quotient({1}, {9, 0, 1}, {1}), 1, 120), 30) ==
        "0.214500369597761462267603076239");
  const UnitQuotient f = unit_quotient({1, -2, 0, 1}, {4, 1}, {7, -3, 1});
  CHECK(to_string(integral(f, Rational(1, 4), 120), 30) == "0.187801339148709134219565730188");
  CHECK(to_string(integral(f, 1, 120), 30) == "0.193589049761677615336377039549");
  const UnitSeries series = *unit_series(f, *unit_bounds(f), 120);
  CHECK(multiply(unit_factor(f, 120), widened(series.whole, series.error), 120)
            .overlaps(integral(f, 1, 120)));
}

// What rounding leaves over at the ends of the series is much more than in its steps.
TEST_CASE("unit series: a denominator of high degree [mpmath: quad of 1/((x − 4)² + 4)⁹]") {
  const UnitQuotient f = unit_quotient({1}, pow(Polynomial{20, -8, 1}, 9), {1});
  CHECK(to_string(integral(f, 1, 120), 30) == "2.34841803423305776368000104482e-11");
}

TEST_CASE("unit series: polynomials and 0") {
  CHECK(integral(unit_quotient({1, 2, 3}, {1}, {4}), 1, 60).contains(2));
  CHECK(integral(unit_quotient({1, 2, 3}, {1}, {4}), 0, 60).contains(Rational(1, 2)));
  CHECK(integral(unit_quotient({}, {1}, {5, 1}), 1, 60).contains(0));
}

TEST_CASE("unit series: the error is one, for any number of bits, and about the one asked for") {
  test::Random random(73);
  long decided = 0;
  for (long k = 0; k < 30 * test::multiplier(); ++k) {
    Polynomial S{random.integer(1, 9)};
    Polynomial D{random.integer(1, 9)};
    for (long factor = random.integer(0, 3); factor > 0; --factor) {
      const Rational re(random.integer(-9, 9), 4);
      const Rational im(random.integer(1, 20), 8);
      (random.integer(0, 1) == 0 ? S : D) *= Polynomial{re * re + im * im, -2 * re, 1};
    }
    const UnitQuotient f = unit_quotient(random.nonzero_polynomial(4), D, S);
    const auto bounds = unit_bounds(f);
    if (!bounds) continue;
    ++decided;
    CAPTURE(D);
    CAPTURE(S);
    const RealBall exact = integral(f, 1, 600);
    for (const long bits : {8, 20, 64, 65, 130, 300}) {
      CAPTURE(bits);
      CHECK(integral(f, 1, bits).overlaps(exact));
      const UnitSeries series = *unit_series(f, *bounds, bits);
      CHECK(series.error.upper() <= power_of_two(-bits));
      CHECK(series.error.upper() > power_of_two(-bits - 12));
      // |∫G| ≤ 2·max |G|.
      CHECK(absolute(series.whole).lower() <= 2 * series.size.upper() + 2 * series.error.upper());
    }
  }
  CHECK(decided > 10);
}
