#include "phrame/algebra/angle.hpp"

#include <doctest/doctest.h>

#include "phrame/algebra/rounding.hpp"

using namespace phrame;

// π = 3.14159265358979323846264338…
TEST_CASE("angle: radians and multiples of pi") {
  CHECK(to_real(Angle(Rational(1, 3))).exact() == Rational(1, 3));
  CHECK_FALSE(to_real(Angle(Rational(1, 4), 0)).exact());
  CHECK(round_to_decimal(to_real(Angle(Rational(1, 4), 0)), 20).value == "0.78539816339744830962");
  CHECK(round_to_decimal(to_real(Angle(-1, 3)), 10).value == "-0.1415926536");
  CHECK(to_string(Angle()) == "0");
  CHECK(to_string(Angle(Rational(-3, 7))) == "-3/7");
  CHECK(to_string(Angle(1, 0)) == "pi");
  CHECK(to_string(Angle(-1, 0)) == "-pi");
  CHECK(to_string(Angle(Rational(-31, 40), 0)) == "-31pi/40");
  CHECK(to_string(Angle(Rational(-1, 4), Rational(1, 3))) == "1/3 - pi/4");
}
