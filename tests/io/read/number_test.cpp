#include "phrame/io/read/number.hpp"

#include <doctest/doctest.h>

#include "phrame/algebra/error.hpp"

using namespace phrame;

TEST_CASE("number: a quotient of numbers of any kind, with blanks") {
  CHECK(parse_number("3/7") == Rational(3, 7));
  CHECK(parse_number("1.5/2.5") == Rational(3, 5));
  CHECK(parse_number("-1.5/0.25") == Rational(-6));
  CHECK(parse_number(" 1e3 / 7 ") == Rational(1000, 7));
  CHECK(parse_number("1/1e2") == Rational(1, 100));
  CHECK(parse_number("0x1p2/3") == Rational(4, 3));
  CHECK(parse_number("\t.5 ") == Rational(1, 2));
}

TEST_CASE("number: what is none is refused whole") {
  for (const char* text : {"", " ", "/", "1/", "/2", "1/2/3", "1 2", "1/-2", "1/+2", "nan/2"}) {
    CAPTURE(text);
    CHECK_THROWS_WITH_AS(parse_number(text), doctest::Contains("is not a number"), InputError);
  }
  CHECK_THROWS_WITH_AS(parse_number("0.5/0.0"), "\"0.5/0.0\" divides by zero", InputError);
  CHECK_THROWS_WITH_AS(parse_number("1/0"), "\"1/0\" divides by zero", InputError);
}
