#include "phrame/ph/curve/gap.hpp"

#include <doctest/doctest.h>

using namespace phrame;

TEST_CASE("gap: what is within 2^-48 of the greatest coordinate is rounding") {
  CHECK(rounding_gap({{1, -4, 2}, {3, 0, 0}}) == Rational(1, Integer(1) << 46));
  const Rational gap(1, 10);
  CHECK(are_within(gap, {0, 0, 0}, {Rational(6, 100), Rational(8, 100), 0}));
  CHECK_FALSE(are_within(gap, {0, 0, 0}, {Rational(6, 100), Rational(8, 100), Rational(1, 1000)}));
}

TEST_CASE(
    "gap: the last point of a closed list becomes the first, if it is that but for rounding") {
  const Rational tiny(1, pow(Integer(10), 16));
  std::vector<Vector<Rational>> points{{1, 0, 0}, {0, 1, 0}, {1, tiny, -tiny}};
  CHECK(close_to_rounding(points));
  CHECK(points.back() == points.front());
  CHECK_FALSE(close_to_rounding(points));  // it is already
  std::vector<Vector<Rational>> open{{1, 0, 0}, {0, 1, 0}, {1, 100 * tiny, 0}};
  CHECK_FALSE(close_to_rounding(open));
  std::vector<Vector<Rational>> two{{1, 0, 0}, {1, tiny, 0}};
  CHECK_FALSE(close_to_rounding(two));  // there and back is nothing
  const Rational far = pow(Integer(10), 6);
  std::vector<Vector<Rational>> small{{far, 0, 0}, {far, 20 * tiny, 0}, {far, 0, tiny}};
  CHECK_FALSE(close_to_rounding(small));  // rounding is as large as they are
}
