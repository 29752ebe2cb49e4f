#include "phrame/algebra/rounding.hpp"

#include <cmath>
#include <cstdlib>
#include <limits>

#include "phrame/algebra/error.hpp"
#include "support/random.hpp"

using namespace phrame;
using test::for_samples;
using test::Random;

namespace {

Real as_enclosure(const Rational& x) {
  return Real([x](long bits) { return RealBall(x, bits); });
}

const Real pi_value{[](long bits) { return pi(bits); }};

}  // namespace

TEST_CASE("rounding: π to 50 digits (Abramowitz & Stegun, table 1.1)") {
  const Decimal d = round_to_decimal(pi_value, 50);
  CHECK(d.value == "3.1415926535897932384626433832795028841971693993751");
  // The next digits of π are 0582…: the error is below 10^-50 and above 10^-52.
  CHECK(parse_rational(d.radius) < parse_rational("1e-50"));
  CHECK(parse_rational(d.radius) > parse_rational("1e-52"));
  CHECK(round_to_double(pi_value) == 0x1.921fb54442d18p+1);
}

TEST_CASE("rounding: what is near to a boundary is told from it as far as it may be near") {
  // 2⁻²⁰⁰⁰⁰ beyond a half: undecided, unless it is known that this may be, or that it is
  // irrational.
  const Rational near = Rational(1, 2) + power_of_two(-20000);
  const Real::Enclosure balls = [near](long bits) {
    RealBall ball(near, bits);
    arb_add_error_2exp_si(ball.raw(), -bits);
    return ball;
  };
  const Real long_number(balls, {false, 20000});
  const Real irrational(balls, {true, 0});
  for (const Real& x : {long_number, irrational, -irrational, irrational + Rational(7, 3),
                        Rational(2) * irrational, cached(irrational)})
    CHECK_NOTHROW(round_to_decimal(x, 20));
  CHECK(round_to_decimal(long_number * Rational(3, 100), 1).value == "0.02");
  CHECK(round_to_decimal(irrational * Rational(3, 100), 1).value == "0.02");
  CHECK_THROWS_AS(round_to_decimal(Real(balls) * Rational(3, 100), 1), Undecided);
  CHECK((irrational + Rational(1)).origin().is_irrational);
  CHECK_FALSE((irrational + irrational).origin().is_irrational);
  CHECK_FALSE((irrational * irrational).origin().is_irrational);
  CHECK((Rational(0) * irrational).exact() == Rational(0));
}

TEST_CASE("rounding: exact numbers, ties to even, carries, exponents") {
  CHECK(round_to_decimal(Rational(0), 5).value == "0");
  CHECK(round_to_decimal(Rational(0), 5).radius == "0");
  CHECK(round_to_decimal(Rational(-4, 5), 3).value == "-0.800");
  CHECK(round_to_decimal(Rational(-4, 5), 3).radius == "0");
  CHECK(round_to_decimal(Rational(1, 8), 2).value == "0.12");
  CHECK(round_to_decimal(Rational(3, 8), 2).value == "0.38");
  CHECK(round_to_decimal(Rational(99996), 4).value == "1.000e5");
  CHECK(round_to_decimal(Rational(9999), 4).value == "9999");
  CHECK(round_to_decimal(Rational(1, 1000000), 3).value == "1.00e-6");
  CHECK(round_to_decimal(Rational(1, 100000), 3).value == "0.0000100");
  CHECK(round_to_decimal(Rational(2, 3), 1).value == "0.7");
  CHECK(round_to_decimal(Rational(2, 3), 1).radius == "3.4e-2");
  CHECK(round_to_decimal(Rational(15), 1).value == "2e1");
  CHECK_THROWS_AS(round_to_decimal(Rational(1), 0), DomainError);
}

TEST_CASE("rounding: law: decimals are the nearest ones, and the radius bounds the error") {
  for_samples(200, [](Random& random) {
    const Rational x = random.rational();
    const long digits = random.integer(1, 30);
    const Decimal d = round_to_decimal(x, digits);
    const Rational value = parse_rational(d.value);
    CHECK(abs(value - x) <= parse_rational(d.radius));
    if (x == 0) return;
    // One unit of the last place: the digits, read as a whole number, are between 10^(d−1) and
    // 10^d.
    const Rational unit = abs(value) / power_of_ten(digits - 1);
    CHECK(abs(value - x) * 2 <= unit);
    // Through enclosures the same digits come out; a short exact decimal is its own neighbour.
    CHECK(round_to_decimal(as_enclosure(x), digits + 40).value ==
          round_to_decimal(x, digits + 40).value);
  });
}

TEST_CASE("rounding: law: doubles agree with the C library's strtod, subnormals included") {
  for_samples(400, [](Random& random) {
    std::string text = std::to_string(random.integer(1, 999999999999999999)) +
                       std::to_string(random.integer(1, 999999999999999999)) + "e" +
                       std::to_string(random.integer(-360, 270));
    if (random.chance(2)) text = "-" + text;
    const double expected = std::strtod(text.c_str(), nullptr);
    CHECK(round_to_double(parse_rational(text)) == expected);
    CHECK(round_to_double(as_enclosure(parse_rational(text))) == expected);
  });
}

TEST_CASE("rounding: doubles: ties to even, overflow, underflow, one zero") {
  CHECK(round_to_double(1 + parse_rational("0x1p-53")) == 1.0);
  CHECK(round_to_double(1 + parse_rational("0x3p-53")) == 1 + 0x1p-51);
  CHECK(round_to_double(1 + parse_rational("0x1p-53") + parse_rational("1e-400")) == 1 + 0x1p-52);
  CHECK(round_to_double(parse_rational("1e400")) == std::numeric_limits<double>::infinity());
  CHECK(round_to_double(parse_rational("1e-400")) == 0);
  CHECK_FALSE(std::signbit(round_to_double(parse_rational("-1e-400"))));
  CHECK(round_to_double(parse_rational("0x1p-1074")) == std::numeric_limits<double>::denorm_min());
  CHECK(round_to_double(parse_rational("0x1p-1075")) == 0);
}

TEST_CASE("rounding: a number that stays on a boundary is undecided, and the limit is named") {
  const Real on_a_tie([](long bits) {
    RealBall ball(Rational(1, 8), bits);
    arb_add_error_2exp_si(ball.raw(), -bits);
    return ball;
  });
  CHECK_THROWS_WITH_AS(round_to_decimal(on_a_tie, 2, {2, 100}),
                       doctest::Contains("bits of precision"), Undecided);
}

TEST_CASE("rounding: a number far below the first precision still gets all its digits") {
  const Rational tiny = parse_rational("123456789e-3000") / 7;
  CHECK(round_to_decimal(as_enclosure(tiny), 20).value == round_to_decimal(tiny, 20).value);
}

TEST_CASE("real: a remembered number is computed anew for more bits only") {
  int asked = 0;
  const Real third = cached(Real([&asked](long bits) {
    ++asked;
    return RealBall(Rational(1, 3), bits);
  }));
  const Real copy = third;  // NOLINT(performance-unnecessary-copy-initialization)
  CHECK(third.enclose(100).contains(Rational(1, 3)));
  CHECK(copy.enclose(50).contains(Rational(1, 3)));
  CHECK(asked == 1);
  CHECK(copy.enclose(200).radius() < Rational(1, Integer(1) << 190U));
  CHECK(asked == 2);
  CHECK(cached(Real(Rational(1, 2))).exact() == Rational(1, 2));
}

TEST_CASE("rounding: the double that all of a ball rounds to") {
  const Rational tie = 1 + power_of_two(-53);
  const Rational narrow = power_of_two(-300);
  CHECK(common_double(hull(Rational(tie - 2 * narrow), Rational(tie - narrow), 400)) == 1.0);
  CHECK(common_double(hull(Rational(tie + narrow), Rational(tie + 2 * narrow), 400)) ==
        1 + 0x1p-52);
  CHECK_FALSE(common_double(hull(Rational(tie - narrow), Rational(tie + narrow), 400)));
  CHECK(common_double(RealBall(tie, 400)) == 1.0);  // ties to even, where it is exact
  CHECK(common_double(hull(Rational(-power_of_two(-1080)), power_of_two(-1090), 64)) == 0.0);
  CHECK_FALSE(std::signbit(*common_double(RealBall(-power_of_two(-1080), 64))));
  CHECK(common_double(RealBall(3 * power_of_two(-1074), 64)) == 3 * 0x1p-1074);
  CHECK(common_double(RealBall(3 * power_of_two(-1075), 64)) == 2 * 0x1p-1074);
}

TEST_CASE("rounding: law: a ball that is known already changes no digit of value and radius") {
  for_samples(400, [](Random& random) {
    // Often next to a tie, to a number of few digits or to a power of ten.
    Rational x = random.rational();
    if (random.chance(2))
      x = Rational(random.integer(1, 9'999'999)) * power_of_ten(-random.integer(0, 20)) +
          (random.chance(2) ? Rational(1, 2) * power_of_ten(-random.integer(6, 30)) : Rational(0));
    if (random.chance(4)) x = power_of_ten(random.integer(-9, 9));
    x += Rational(random.integer(-1000, 1000)) * power_of_ten(-random.integer(15, 45));
    x += Rational(1, 3) * power_of_ten(-60);  // no tie
    if (random.chance(2)) x = -x;
    const Real::Enclosure balls = [x](long bits) {
      RealBall ball(x, std::max(bits, 128L));
      arb_add_error_2exp_si(ball.raw(), -std::max(bits, 128L));
      return ball;
    };
    const long digits = random.integer(1, 19);
    const Real ordinary(balls, {true, 0});
    RealBall near(x + Rational(random.integer(-9, 9)) * power_of_two(-100), 140);
    arb_add_error_2exp_si(near.raw(), -random.integer(50, 96));
    REQUIRE(near.contains(x));
    const Decimal with = round_to_decimal({balls, {true, 0}, near}, digits);
    const Decimal without = round_to_decimal(ordinary, digits);
    CHECK(with.value == without.value);
    CHECK(with.radius == without.radius);
    CHECK(round_to_double({balls, {true, 0}, near}) == round_to_double(ordinary));
  });
}

TEST_CASE("rounding: a ball that decides is all that is asked") {
  const Real::Enclosure none = [](long) -> RealBall { throw Error("asked"); };
  RealBall third(Rational(1, 3), 120);
  CHECK(round_to_decimal({none, {true, 0}, third}, 17).value == "0.33333333333333333");
  CHECK(round_to_decimal({none, {true, 0}, third}, 17).radius == "3.4e-18");
  CHECK(round_to_double({none, {true, 0}, third}) == 1.0 / 3);
  arb_add_error_2exp_si(third.raw(), -40);
  CHECK_THROWS_AS(round_to_decimal({none, {true, 0}, third}, 17), Error);
  CHECK(round_to_decimal({none, {true, 0}, third}, 8).value == "0.33333333");
}
