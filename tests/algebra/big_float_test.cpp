#include "phrame/algebra/big_float.hpp"

#include <doctest/doctest.h>

#include <cmath>

#include "phrame/algebra/rounding.hpp"

using namespace phrame;

TEST_CASE("BigFloat: results have the bits of the operand with more, rounded to nearest") {
  const BigFloat third = BigFloat(Rational(1), 200) / BigFloat(3.0);
  // |1/3 − x| ≤ 2^−202 for a number of 200 bits in [1/4, 1/2).
  const Rational scaled(third.scaled(201));
  CHECK(abs(scaled * power_of_two(-201) - Rational(1, 3)) <= power_of_two(-202));
  CHECK(third.scaled(1) == 1);
  CHECK((third * BigFloat(3.0)).to_double() == 1.0);
  const BigFloat two = BigFloat(Rational(1, 3), 200) + BigFloat(Rational(5, 3), 100);
  CHECK(two.scaled(0) == 2);
  CHECK((-(two - BigFloat(5.0))).scaled(0) == 3);
}

TEST_CASE("BigFloat: a root of 300 bits has a square that agrees to 298") {
  const BigFloat x(Rational(2), 300);
  const Rational square(sqrt(x).scaled(299) * sqrt(x).scaled(299));
  CHECK(abs(square * power_of_two(-598) - 2) < power_of_two(-297));
}

TEST_CASE("BigFloat: scaled() is the integer next to 2^k x, for every k") {
  CHECK(BigFloat(Rational(7, 2), 64).scaled(0) == 4);
  CHECK(BigFloat(Rational(5, 2), 64).scaled(0) == 2);  // the even one
  CHECK(BigFloat(Rational(-7, 3), 64).scaled(0) == -2);
  CHECK(BigFloat(Rational(1000), 64).scaled(-3) == 125);
  CHECK(BigFloat(0.0).scaled(100) == 0);
  CHECK(BigFloat(0.0) == BigFloat());
  CHECK(BigFloat(-1.0) < BigFloat(Rational(1, 3), 10));
}
