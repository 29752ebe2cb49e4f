#include "phrame/io/read/svg_number.hpp"

#include <doctest/doctest.h>

#include <vector>

#include "phrame/algebra/error.hpp"

namespace svg_number_test {

using namespace phrame;

// SVG 1.1, 8.3.9: numbers need nothing between them where a sign or a point tells them apart.
TEST_CASE("SVG numbers: what is between them may be left out where they can be told apart") {
  SvgNumbers numbers("M 1.5.5-3e2,+7.,0.1e-2", 1);
  std::vector<Rational> found;
  while (numbers.is_at_number()) found.push_back(numbers.number());
  CHECK(numbers.at_end());
  CHECK(found == std::vector<Rational>{Rational(3, 2), Rational(1, 2), -300, 7, Rational(1, 1000)});
}

TEST_CASE("SVG numbers: an e that no exponent follows is what comes next") {
  SvgNumbers numbers("5em", 0);
  CHECK(numbers.number() == 5);
  CHECK(numbers.take_word() == "em");
  CHECK(numbers.at_end());
}

TEST_CASE("SVG numbers: flags need nothing behind them") {
  SvgNumbers numbers("0 01.5 2", 0);
  CHECK(numbers.number() == 0);
  CHECK_FALSE(numbers.flag());
  CHECK(numbers.flag());
  CHECK(numbers.number() == Rational(1, 2));
  CHECK_THROWS_AS(numbers.flag(), InputError);
}

TEST_CASE("SVG numbers: letters, characters and places") {
  SvgNumbers numbers("m 1\n (2", 0);
  CHECK(numbers.take_letter("lL") == 0);
  CHECK(numbers.take_letter("mM") == 'm');
  CHECK(numbers.number() == 1);
  CHECK(numbers.place() == "2:2");
  CHECK_FALSE(numbers.is_at_number());
  CHECK_THROWS_AS(numbers.number(), InputError);
  CHECK_FALSE(numbers.take(')'));
  CHECK(numbers.take('('));
  CHECK(numbers.place() == "2:3");
}

}  // namespace svg_number_test
