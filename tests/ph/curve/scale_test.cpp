#include "phrame/ph/curve/scale.hpp"

#include "phrame/algebra/rounding.hpp"
#include "support/random.hpp"

using namespace phrame;
using test::for_samples;
using test::Random;

TEST_CASE("scale_for_doubles: a power of 4 that brings a number between 1/4 and 4") {
  for (const long e : {-997L, -100L, -3L, -2L, -1L, 0L, 1L, 2L, 3L, 1001L}) {
    CAPTURE(e);
    const Rational x = Rational(5, 4) * power_of_two(e);
    const Rational scale = scale_for_doubles(x);
    CHECK(square_root(scale).has_value());
    CHECK(scale * x >= Rational(1, 4));
    CHECK(scale * x <= 4);
  }
  CHECK(scale_for_doubles(0) == 1);
  CHECK(scaled_to_doubles(Rational(1, 4), {1, -2, 0}) == Vector<double>{0.25, -0.5, 0});
}

TEST_CASE("rounded_to_bits and rounded_to_places are near, and short") {
  for_samples(50, [](Random& random) {
    const Rational x = abs(random.rational()) + Rational(1, 7);
    const Rational y = rounded_to_bits(x, 12);
    CHECK(abs(y - x) <= x * power_of_two(-11));
    CHECK(bit_length(numerator(y)) <= 13);
    const Rational z = rounded_to_places(-x, 20);
    CHECK(abs(z + x) <= power_of_two(-21));
    CHECK(denominator(z * power_of_two(20)) == 1);
  });
  CHECK(rounded_to_bits(power_of_two(-500), 12) == power_of_two(-500));
}

TEST_CASE("square_root_above is an upper bound, and a near one") {
  for_samples(50, [](Random& random) {
    const Rational x = abs(random.rational()) * power_of_two(random.integer(-300, 300));
    const Rational root = square_root_above(x);
    CHECK(root * root >= x);
    CHECK(root * root * (1 - power_of_two(-29)) <= x);
  });
  CHECK(square_root_above(0) == 0);
  CHECK(square_root_above(4) >= 2);
}

TEST_CASE("largest is the greatest coordinate, whatever its sign") {
  CHECK(largest(Vector<Rational>{1, -3, 2}) == 3);
  CHECK(largest({{1, -3, 2}, {0, 0, 4}}) == 4);
}

TEST_CASE("squared_sine is that of the angle, 1 where that is not acute") {
  CHECK(squared_sine({2, 0, 0}, {3, 4, 0}) == Rational(16, 25));
  CHECK(squared_sine({1, 1, 0}, {5, 5, 0}) == 0);
  CHECK(squared_sine({1, 0, 0}, {-3, 4, 0}) == 1);
  CHECK(squared_sine({1, 0, 0}, {0, 4, 0}) == 1);
}
