#include "phrame/algebra/fixed_point.hpp"

#include "phrame/algebra/error.hpp"
#include "support/doubles.hpp"

using namespace phrame;

TEST_CASE("fixed point: rational numbers, half to even") {
  CHECK(round_to_places(Rational(1, 3), 4) == 3333);
  CHECK(round_to_places(Rational(-2, 3), 4) == -6667);
  CHECK(round_to_places(Rational(5, 100000), 4) == 0);
  CHECK(round_to_places(Rational(15, 100000), 4) == 2);
  CHECK(round_to_places(Rational(-25, 100000), 4) == -2);
  CHECK(round_to_places(Rational(7, 2), 0) == 4);
  CHECK(round_to_places(Rational(0), 9) == 0);
  CHECK(round_to_places(Rational(1234567), 0) == 1234567);
}

// π = 3.14159265358979323846264338327950288…
TEST_CASE("fixed point: balls, until both ends round to the same") {
  const Real number([](long bits) { return pi(bits); });
  CHECK(round_to_places(number, 0) == 3);
  CHECK(round_to_places(number, 4) == 31416);
  CHECK(round_to_places(-number, 4) == -31416);
  CHECK(round_to_places(number, 30) == Integer("3141592653589793238462643383280"));
  CHECK(round_to_places(number * Rational(1, 1000000), 4) == 0);
  CHECK(round_to_places(number * Rational(10000000000), 2) == Integer("3141592653590"));
  // What is 0, and is not known to be, is no boundary; a half is one.
  const Real zero([](long bits) { return subtract(pi(bits), pi(bits), bits); });
  CHECK(round_to_places(zero, 4) == 0);
  CHECK_THROWS_AS(round_to_places(zero + Rational(1, 2), 0), Undecided);
}

TEST_CASE("fixed point: as text") {
  CHECK(fixed_point_text(0, 4) == "0.0000");
  CHECK(fixed_point_text(-1, 4) == "-0.0001");
  CHECK(fixed_point_text(12345, 4) == "1.2345");
  CHECK(fixed_point_text(-1234567, 2) == "-12345.67");
  CHECK(fixed_point_text(-7, 0) == "-7");
}
