#include "phrame/io/write/angle_text.hpp"

#include <doctest/doctest.h>

#include "phrame/algebra/error.hpp"

using namespace phrame;

TEST_CASE("angle text: multiples of π, radians and degrees") {
  const auto multiple = [](const Rational& c) { return Angle(c, 0); };
  CHECK(parse_angle("pi/8") == multiple(Rational(1, 8)));
  CHECK(parse_angle("-31pi/40") == multiple(Rational(-31, 40)));
  CHECK(parse_angle("0.125pi") == multiple(Rational(1, 8)));
  CHECK(parse_angle("5/8*pi") == multiple(Rational(5, 8)));
  CHECK(parse_angle("-π") == multiple(-1));
  CHECK(parse_angle("+pi") == multiple(1));
  CHECK(parse_angle("1e-2π/3") == multiple(Rational(1, 300)));
  CHECK(parse_angle("1.5/2.5*pi") == multiple(Rational(3, 5)));
  CHECK(parse_angle(" -31 pi / 40 ") == multiple(Rational(-31, 40)));
  CHECK(parse_angle("45deg") == multiple(Rational(1, 4)));
  CHECK(parse_angle("-22.5 deg") == multiple(Rational(-1, 8)));
  CHECK(parse_angle("1/3°") == multiple(Rational(1, 540)));
  CHECK(parse_angle("0.3927") == Angle(Rational(3927, 10000)));
  CHECK(parse_angle("-3/7") == Angle(Rational(-3, 7)));
}

TEST_CASE("angle text: what is no angle is refused") {
  for (const char* text : {"", "pie", "pi/", "pi/0", "*pi", "2**pi", "pi*2", "pi/8pi", "x", "1/0",
                           "pi + 1", "--pi", "deg", "45degrees", "45deg/2", "pi deg"}) {
    CAPTURE(text);
    CHECK_THROWS_AS(parse_angle(text), InputError);
  }
}

TEST_CASE("angle text: two divisions are refused, as in 1/2/3, and the text is named") {
  for (const std::string text : {"1/2/3", "5pi/4/2", "pi/4/4", "pi/1/2", "5/8*pi/2", "1/2/3deg"}) {
    CAPTURE(text);
    CHECK_THROWS_WITH_AS(
        parse_angle(text),
        ("\"" + text + "\" is not an angle such as pi/8, -31pi/40, 45deg or, in radians, 0.3927")
            .c_str(),
        InputError);
  }
}
